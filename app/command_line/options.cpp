#include "app/command_line/options.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/command_line/options_commands.h"
#include "app/files/nearest_names.h"

namespace throng::app {
namespace {

// A model's file has an ending, or lies in a folder.
std::optional<std::string> command_meant(const std::string& word) {
  static const std::vector<std::string> commands{"pose", "inspect", "lod", "bench", "bake"};
  if (word.empty() || word.find_first_of("-./\\") != std::string::npos) return {};
  std::error_code unknown;
  return std::filesystem::exists(word, unknown) ? std::nullopt : name_meant(word, commands);
}

}  // namespace

ParsedCommand parse_command_line(const std::vector<std::string>& arguments) {
  const std::string command = arguments.empty() ? "" : arguments.front();
  const std::vector<std::string> rest(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
  if (command == "pose") return parse_pose(rest);
  if (command == "inspect") return parse_inspect(rest);
  if (command == "lod") return parse_lod(rest);
  if (command == "bench") return parse_bench(rest);
  if (command == "bake") return parse_bake(rest);
  if (const auto meant = command_meant(command)) {
    return UsageError{command + ": there is no such command nor file; is throng " + *meant + " meant?"};
  }
  return parse_demo(arguments);
}

}  // namespace throng::app
