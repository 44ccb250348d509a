#pragma once

#include <set>
#include <string>

#include "tests/house/house_rules.h"

namespace throng::house {

inline constexpr int most_public_methods = 30;

/// No class in a header of engine/ or app/ has more public methods, but for the excused ones. Constructors and
/// operators count; what is deleted, inherited or a friend does not.
Findings classes_with_too_many_methods(const Tree& tree, const std::set<std::string>& excused = {});

}  // namespace throng::house
