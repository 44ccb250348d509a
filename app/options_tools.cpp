#include <limits>

#include "app/option_reader.h"
#include "app/options_commands.h"
#include "app/options_scheduling.h"

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

ParsedCommand parse_bench(const std::vector<std::string>& arguments) {
  BenchOptions options;
  OptionReader reader("throng bench", "Measures what an update of many agents costs, with LOD and crowd logic off.");
  reader.heading("What is measured");
  reader.model(options.model, "A glTF file; without it, a branching skeleton is built", OptionReader::Need::optional);
  reader.value("--agents", "N", "Agents, 1 to 100000 (1000)", whole_number(options.agents, 1, 100000));
  reader.value("--bones", "N", "Bones of the built skeleton, 1 to 1024 (62)", whole_number(options.bones, 1, 1024));
  reader.value("--clips", "K", "Different clips for it, 1 to 256 (2)", whole_number(options.clips, 1, 256));
  reader.value("--frames", "N", "Frames a round (60)",
               whole_number(options.frames, 1, std::numeric_limits<int>::max()));
  reader.value("--json", "FILE|-", "Write the figures as one JSON object", any_text(options.json));
  reader.later("--machine");
  declare_scheduling(reader, options);
  if (auto stop = reader.read(arguments)) return *stop;
  for (const char* const built_only : {"--bones", "--clips"}) {
    if (!options.model.empty() && reader.given(built_only)) {
      return UsageError{std::string(built_only) + ": a model brings its own; give one or the other"};
    }
  }
  return options;
}

}  // namespace throng::app
