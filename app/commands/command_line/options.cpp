#include "app/commands/command_line/options.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands/command_line/options_commands.h"
#include "app/files/nearest_names.h"

namespace throng::app {
namespace {

struct Command {
  std::string name;
  ParsedCommand (*parse)(const std::vector<std::string>& arguments);
};

const std::array<Command, 7>& commands() {
  static const std::array<Command, 7> all{{{"pose", parse_pose},
                                           {"inspect", parse_inspect},
                                           {"lod", parse_lod},
                                           {"bench", parse_bench},
                                           {"bake", parse_bake},
                                           {"check", parse_check},
                                           {"compare", parse_compare}}};
  return all;
}

// A model's file has an ending, or lies in a folder.
std::optional<std::string> command_meant(const std::string& word) {
  if (word.empty() || word.find_first_of("-./\\") != std::string::npos) return {};
  std::error_code unknown;
  if (std::filesystem::exists(word, unknown)) return {};
  std::vector<std::string> names;
  for (const Command& command : commands()) names.push_back(command.name);
  return name_meant(word, names);
}

}  // namespace

ParsedCommand parse_command_line(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return parse_demo(arguments);
  const std::string& word = arguments.front();
  const auto command = std::ranges::find(commands(), word, &Command::name);
  if (command != commands().end()) return command->parse({arguments.begin() + 1, arguments.end()});
  if (const auto meant = command_meant(word)) {
    return UsageError{word + ": there is no such command nor file; is throng " + *meant + " meant?"};
  }
  return parse_demo(arguments);
}

}  // namespace throng::app
