#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace throng::test {

/// Expects of a character that its program made now that its numbers are those of the file `name` in assets, to within
/// the steps that the program rounds to.
void expect_rounded_alike(const std::vector<std::byte>& made, const std::string& name);

}  // namespace throng::test
