#include <limits>
#include <optional>
#include <string>

#include "app/command_line/option_reader.h"
#include "app/command_line/options_commands.h"
#include "app/command_line/options_scheduling.h"

namespace throng::app {

ParsedCommand parse_pose(const std::vector<std::string>& arguments) {
  PoseOptions options;
  OptionReader reader("throng pose", "Writes the joints and palettes of every skin of a file.");
  reader.heading("What is posed");
  reader.model(options.model, "A glTF file (.glb or .gltf)", OptionReader::Need::required);
  reader.value("--clip", "NAME|INDEX", "A clip of the file, or none", any_text(options.clip),
               OptionReader::Need::required);
  reader.value("--time", "T[,T...]", "Seconds", times_list(options.times), OptionReader::Need::required);
  reader.value("--stream", "NAME", "sampled or keyframe (sampled)",
               choice<Stream>(options.stream, {{"sampled", Stream::sampled}, {"keyframe", Stream::keyframe}}));
  reader.value("--json", "FILE|-", "Where to write", any_text(options.json), OptionReader::Need::required);
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

ParsedCommand parse_inspect(const std::vector<std::string>& arguments) {
  InspectOptions options;
  OptionReader reader("throng inspect", "Says what was found in a file, what was repaired and what was refused.");
  reader.heading("What is inspected");
  reader.model(options.model, "A glTF file (.glb or .gltf)", OptionReader::Need::required);
  reader.flag("--json", options.json, "As one JSON object");
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

ParsedCommand parse_lod(const std::vector<std::string>& arguments) {
  LodOptions options;
  OptionReader reader("throng lod", "Measures what each bone level of a character saves, and what it shows.");
  reader.heading("What is measured");
  reader.model(options.model, "A glTF file (.glb or .gltf); without it, the built-in character",
               OptionReader::Need::optional);
  reader.value("--pixels", "N", "Height on screen for errors in pixels, 1 to 10000 (200)",
               whole_number(options.pixels, 1, 10000));
  reader.heading("Files");
  reader.value("--json", "FILE|-", "Write the figures as one JSON object", any_text(options.json));
  reader.value("--plot", "FILE.svg", "Draw them", svg_file(options.plot));
  reader.value("--export", "FILE", "Write distances, intervals, bones and meshes for another engine",
               file_name(options.export_file));
  reader.value("--data", "DIR", "Folder of assets", existing_folder(options.data));
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

namespace {

void declare_measured(OptionReader& reader, BenchOptions& options) {
  reader.heading("What is measured");
  reader.model(options.model, "A glTF file; without it, a branching skeleton is built", OptionReader::Need::optional);
  reader.value("--agents", "N[,N...]", "Agents, 1 to 100000 (1000); of every list each, in every combination",
               number_list(options.agents, 1, 100000));
  reader.value("--bones", "N[,N...]", "Bones of the built skeleton, 1 to 1024 (62)",
               number_list(options.bones, 1, 1024));
  reader.value("--clips", "K[,K...]", "Different clips for it, 1 to 256 (2)", number_list(options.clips, 1, 256));
  reader.value("--frames", "N", "Rounds in which all that is compared takes turns (60)",
               whole_number(options.frames, 1, std::numeric_limits<int>::max()));
  reader.value("--sweep", "NAME", "Instead: grain, below which size tasks are too small",
               choice<Sweep>(options.sweep, {{"grain", Sweep::grain}}));
  reader.value("--machine", "FILE", "Instead: what a machine with other local stores would do; ps2, spe or a file",
               file_name(options.machine));
}

void declare_scheduling(OptionReader& reader, BenchOptions& options) {
  reader.heading("Scheduling");
  reader.value("--pus", "N[,N...]", "PUs, the calling thread among them, 1 to 256 (all cores)",
               number_list(options.pus, 1, 256));
  reader.value("--schedule", "NAME[,NAME]", "fused or levels (fused)",
               choice_list(options.schedules, schedule_names()));
  reader.value("--stream", "NAME[,NAME]", "sampled or keyframe (sampled)",
               choice_list(options.streams, stream_names()));
  declare_local_store(reader, options);
  declare_palette(reader, options);
}

void declare_files(OptionReader& reader, BenchOptions& options) {
  reader.heading("Files");
  reader.value("--json", "FILE|-", "Write the figures as one JSON object", any_text(options.json));
  reader.value("--plot", "FILE.svg", "Draw them", svg_file(options.plot));
  reader.value("--trace", "FILE", "Write what each PU did when, for ui.perfetto.dev", file_name(options.trace));
  reader.value("--data", "DIR", "Folder of assets/machines", existing_folder(options.data));
}

std::optional<std::string> contradiction_in(const OptionReader& reader, const BenchOptions& options) {
  for (const char* const built_only : {"--bones", "--clips"}) {
    if (!options.model.empty() && reader.given(built_only)) {
      return std::string(built_only) + ": a model brings its own; give one or the other";
    }
  }
  const bool table = options.sweep == Sweep::none && options.machine.empty();
  if (options.sweep != Sweep::none && !options.machine.empty())
    return "--machine: contradicts --sweep; give one of them";
  if (!table && !options.trace.empty()) return "--trace: is of the table only; leave --sweep and --machine out";
  if (!options.machine.empty() && !options.plot.empty()) return "--plot: there is nothing to draw of --machine";
  return {};
}

}  // namespace

ParsedCommand parse_bench(const std::vector<std::string>& arguments) {
  BenchOptions options;
  OptionReader reader("throng bench", "Measures what an update of many agents costs, with LOD and crowd logic off.");
  declare_measured(reader, options);
  declare_scheduling(reader, options);
  declare_files(reader, options);
  if (auto stop = reader.read(arguments)) return *stop;
  if (auto contradiction = contradiction_in(reader, options)) return UsageError{*contradiction};
  return options;
}

}  // namespace throng::app
