// The options that a crowd begins with: a file of all that was open, a preset, single values.
#include <set>
#include <string>

#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options_commands.h"
#include "app/settings/preset.h"
#include "app/show/request/crowd_file.h"

namespace throng::app {

ValueReader crowd_file_name(DemoOptions& options) {
  return [&options](const std::string& text) -> Complaint {
    if (!options.crowd_file.empty()) return "one crowd file is the most; open the other one in the window";
    const auto setup = read_crowd_file(text);
    if (!setup) return setup.error().message.substr(text.size() + std::string_view(": ").size());
    options.crowd_file = text;
    begin_with(*setup, options);
    options.values_given.all = true;
    return {};
  };
}

void declare_starting_values(OptionReader& reader, DemoOptions& options) {
  reader.option_defaults()->group("Starting values; options given beside them win");
  reader.value("--crowd", "JSON",
               "What a file NAME.throng says, as text; all of it can be left out, and names of files are as given",
               crowd_text(options));
  reader.value("--preset", "NAME|FILE", "A preset by its name in the overlay, or a file (none)",
               preset_values(options));
  reader.value("--set", "KEY=VALUE,...", "Any value of a preset by its key", set_values(options));
}

std::optional<std::string> contradiction_of_crowd(const DemoOptions& options) {
  if (options.crowd == nullptr) return {};
  static const std::set<std::string> of_characters{"--cast", "--clips-from", "--skin", "--scale", "--up", "--ground"};
  const std::string said_by = options.crowd_file.empty() ? "--crowd" : options.crowd_file;
  const bool says_characters = !options.crowd->characters.empty();
  const bool says_tracks = !options.crowd->trajectories.file.empty();
  if (says_characters && !options.models.empty()) return options.models.front() + ": " + said_by + " says who is there";
  for (const std::string& name : options.given) {
    const bool is_said = name == "--replay" || (name == "--crowd" && !options.crowd_file.empty()) ||
                         (says_characters && of_characters.contains(name)) || (says_tracks && name == "--trajectories");
    if (is_said) return name + ": " + said_by + " says it; leave it out";
  }
  return {};
}

}  // namespace throng::app
