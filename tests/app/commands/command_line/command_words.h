#pragma once

#include <iterator>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/commands/command_line/options.h"

namespace throng::app {

/// Returns the words of a line, as a shell would part them where nothing is quoted.
inline std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// Returns why a command line cannot be obeyed; "(accepted)" if it can.
inline std::string refusal_of(const std::vector<std::string>& arguments) {
  const ParsedCommand command = parse_command_line(arguments);
  const auto* const error = std::get_if<UsageError>(&command);
  return error == nullptr ? "(accepted)" : error->message;
}
inline std::string refusal(const std::string& line) { return refusal_of(words(line)); }

/// A line that is refused with these words; `name` is that of the test.
struct Refused {
  std::string name;
  std::string line;
  std::string message;
};
inline std::string name_of(const testing::TestParamInfo<Refused>& info) { return info.param.name; }

}  // namespace throng::app
