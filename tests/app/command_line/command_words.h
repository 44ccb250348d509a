#pragma once

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace throng::app {

/// Returns the words of a line, as a shell would part them where nothing is quoted.
inline std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace throng::app
