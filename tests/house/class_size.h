#pragma once

#include "tests/house/house_rules.h"

namespace throng::house {

inline constexpr int most_public_methods = 30;

/// Finds classes in headers of engine/ and app/ that have more public methods. Constructors and operators count.
/// Methods that are deleted, inherited or friends do not.
Findings classes_with_too_many_methods(const Tree& tree);

}  // namespace throng::house
