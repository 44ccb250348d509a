#include <optional>
#include <string>

#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options_commands.h"
#include "app/settings/option_values.h"

namespace throng::app {
namespace {

ValueReader contexts(std::vector<ContextKind>& target) {
  return choice<std::vector<ContextKind>>(target, {{"egl", {ContextKind::egl}},
                                                   {"osmesa", {ContextKind::osmesa}},
                                                   {"both", {ContextKind::egl, ContextKind::osmesa}}});
}

/// A limit on a command line needs no reason: the person who types it has one.
ValueReader limit(std::optional<DifferenceLimit>& target, float most) {
  return [&target, most](const std::string& text) -> Complaint {
    double value = 0;
    if (Complaint complaint = read_number(text, 0, most, value)) return complaint;
    target = DifferenceLimit{.most = value, .because = "given"};
    return {};
  };
}

ValueReader png(std::string& target) { return file_that_ends_in(".png", target); }

}  // namespace

void declare_software(OptionReader& reader, DemoOptions& options) {
  reader.flag("--software", options.force_software,
              "Headless: never on a graphics card, so that pictures are the same");
}

ParsedCommand parse_check(const std::vector<std::string>& arguments) {
  CheckOptions options;
  OptionReader reader("throng check",
                      "Draws the pictures that a file of cases asks for, and compares them with expected ones.");
  reader.option_defaults()->group("What is drawn");
  reader
      .value("CASES", "", "A file of cases (.json); app/commands/check/README.md has its keys",
             file_name(options.cases))
      ->required()
      ->group("Cases");
  reader.value("--case", "NAME,...", "These of its cases (all)", file_names(options.names));
  reader.value("--context", "egl|osmesa|both", "What all are drawn with (as each case says, else EGL)",
               contexts(options.contexts));
  reader.flag("--update", options.update, "Write the expected pictures; refuses what git could not bring back");
  reader.flag("--force", options.force, "With --update: replace what git could not bring back");
  reader.option_defaults()->group("Files");
  reader.value("--out", "DIR", "Folder for what is drawn, differences and heat maps (throng-check)",
               file_name(options.out));
  reader.value("--report", "FILE.html", "One page with all pictures (report.html in --out)",
               file_that_ends_in(".html", options.report));
  reader.value("--junit", "FILE.xml", "The results for a server that builds and tests (none)",
               file_that_ends_in(".xml", options.junit));
  reader.value("--data", "DIR", "Folder of shaders and assets", existing_folder(options.data));
  reader.footer(
      "Example:\n"
      "  throng check cases.json --update    # once, and whenever a change is meant; then look at the pictures\n"
      "  throng check cases.json             # ends with 1 if a picture differs, 2 if the file is wrong");
  if (auto stop = reader.read(arguments)) return *stop;
  if (options.force && !options.update) return UsageError{"--force: goes with --update"};
  return options;
}

ParsedCommand parse_compare(const std::vector<std::string>& arguments) {
  CompareOptions options;
  OptionReader reader("throng compare", "Says how far two pictures are apart; without a limit, they must be the same.");
  reader.option_defaults()->group("Pictures");
  reader.value("EXPECTED", "", "A .png", png(options.expected))->required()->group("Pictures");
  reader.value("ACTUAL", "", "Another of the same size", png(options.actual))->required()->group("Pictures");
  reader.option_defaults()->group("What is allowed");
  reader.value("--mean", "X", "Mean over the picture at most, in steps of 255 a channel",
               limit(options.tolerance.mean, 255));
  reader.value("--worst-block", "X", "The same of any 16x16 pixels", limit(options.tolerance.worst_block, 255));
  reader.value("--share", "X",
               "Share of pixels that are off by more than " + std::to_string(seen_steps) + " steps, 0 to 1",
               limit(options.tolerance.share, 1));
  reader.option_defaults()->group("Files");
  reader.value("--difference", "FILE.png", "Write the difference, 8 times as bright", png(options.difference));
  reader.parts_remover(options.remove_parts);
  reader.footer("Example:\n  throng compare before.png after.png --mean 0.8 --worst-block 9");
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

}  // namespace throng::app
