// The files that the options of a command name.
#include <span>

#include "app/commands/command_line/options.h"

namespace throng::app {
namespace {

RunFiles reading(std::span<const std::string> models, std::span<const std::string> clips_from) {
  RunFiles files;
  for (const std::string& model : models) files.read_model(model);
  for (const std::string& file : clips_from) files.read.push_back({"--clips-from", file});
  return files;
}

}  // namespace

RunFiles files_of(const DemoOptions& options) {
  RunFiles files = reading(options.models, options.clips_from);
  for (const CastEntry& entry : options.cast) files.read_model(entry.file);
  files.read.push_back({"MODEL", options.crowd_file});
  files.read.push_back({"--preset", options.preset});
  files.read.push_back({"--cast", options.cast_rules});
  if (options.trajectories.file != "-") files.read.push_back({"--trajectories", options.trajectories.file});
  files.read.push_back({"--walls", options.trajectories.reading.walls});
  files.read.push_back({"--replay", options.replay});
  files.written = {{"--screenshot", options.screenshot}, {"--stats", options.stats},
                   {"--trace", options.trace},           {"--record", options.record},
                   {"--ui-map", options.ui_map},         {"--video", options.output.video}};
  files.remove_parts = options.remove_parts;
  return files;
}

RunFiles files_of(const PoseOptions& options) {
  RunFiles files = reading({&options.model, 1}, options.clips_from);
  files.written = {{"--json", options.json}};
  files.remove_parts = options.remove_parts;
  return files;
}

RunFiles files_of(const InspectOptions& options) {
  RunFiles files = reading({&options.model, 1}, options.clips_from);
  files.written = {{"--measures", options.measures}};
  return files;
}

RunFiles files_of(const LodOptions& options) {
  RunFiles files = reading({&options.model, 1}, {});
  files.written = {{"--json", options.json}, {"--plot", options.plot}, {"--export", options.export_file}};
  files.remove_parts = options.remove_parts;
  return files;
}

RunFiles files_of(const BenchOptions& options) {
  RunFiles files = reading({&options.model, 1}, {});
  files.written = {{"--json", options.json}, {"--plot", options.plot}, {"--trace", options.trace}};
  files.remove_parts = options.remove_parts;
  return files;
}

RunFiles files_of(const BakeOptions& options) {
  RunFiles files = reading(options.models, options.clips_from);
  files.written = {{"-o", options.pack}};
  files.remove_parts = options.remove_parts;
  return files;
}

RunFiles files_of(const CheckOptions& options) {
  RunFiles files;
  files.read = {{"CASES", options.cases}};
  files.written = {{"--report", options.report}, {"--junit", options.junit}};
  return files;
}

RunFiles files_of(const CompareOptions& options) {
  RunFiles files;
  files.read = {{"EXPECTED", options.expected}, {"ACTUAL", options.actual}};
  files.written = {{"--difference", options.difference}};
  files.remove_parts = options.remove_parts;
  return files;
}

}  // namespace throng::app
