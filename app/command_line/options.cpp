#include "app/command_line/options.h"

#include "app/command_line/options_commands.h"

namespace throng::app {

ParsedCommand parse_command_line(const std::vector<std::string>& arguments) {
  const std::string command = arguments.empty() ? "" : arguments.front();
  const std::vector<std::string> rest(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
  if (command == "pose") return parse_pose(rest);
  if (command == "inspect") return parse_inspect(rest);
  if (command == "lod") return parse_lod(rest);
  if (command == "bench") return parse_bench(rest);
  if (command == "bake") return parse_bake(rest);
  return parse_demo(arguments);
}

}  // namespace throng::app
