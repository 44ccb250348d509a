#pragma once

#include "tests/house/house_rules.h"

namespace throng::house {

inline constexpr int most_public_methods = 30;

/// No class in a header of engine/ or app/ has more public methods. Constructors and operators count; what is
/// deleted, inherited or a friend does not.
Findings classes_with_too_many_methods(const Tree& tree);

}  // namespace throng::house
