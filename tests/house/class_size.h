#pragma once

#include <string>
#include <vector>

#include "tests/house/house_rules.h"

namespace throng::house {

inline constexpr int most_public_methods = 32;

/// A class in a header of engine/ or app/. Constructors, operators and friend functions count as methods. Methods that
/// are deleted or inherited and operators that are friends do not.
struct ClassSize {
  std::string name;  ///< "path:line: class"
  int public_methods = 0, private_methods = 0;
};

/// Returns all classes, those with most public methods first.
std::vector<ClassSize> class_sizes(const Tree& tree);

/// Finds classes that have more than most_public_methods.
Findings classes_with_too_many_methods(const Tree& tree);

/// Finds functions in app/ that are friends of a class and no operators.
Findings friends_that_are_methods(const Tree& tree);

}  // namespace throng::house
