// The options that say what a run writes of each of its frames.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options_commands.h"

namespace throng::app {
namespace {

constexpr double least_rate = 0.1, most_rate = 1000;

ValueReader video_file(std::string& target) {
  return [&target](const std::string& text) -> Complaint {
    if (!text.ends_with(".mp4") && !text.ends_with(".webm")) return "must be a file name that ends in .mp4 or .webm";
    target = text;
    return {};
  };
}

ValueReader folder_name(std::string& target) {
  return [&target](const std::string& text) -> Complaint {
    if (text.empty() || text == "-") return "must be the name of a folder";
    target = text;
    return {};
  };
}

/// Returns the option that asks for a file of each frame; empty where none does.
std::string asked_by(const OutputOptions& output) {
  if (!output.video.empty()) return "--video";
  if (!output.pictures.empty()) return "--pictures";
  return output.labels.empty() ? "" : "--labels";
}

/// Returns whether an option changes a picture; a run can go on with other values of the rest.
bool changes_a_picture(const std::string& option) {
  static const std::set<std::string> others{"--video",  "--pictures", "--labels", "--frames",       "--seconds",
                                            "--stats",  "--events",   "--trace",  "--screenshot",   "--ui-map",
                                            "--record", "--data",     "--pus",    "--remove-parts", "--progress"};
  return !others.contains(option);
}

std::vector<std::string> words_of_run(const OptionReader& reader, const DemoOptions& options) {
  std::vector<std::string> words;
  for (const CLI::Option* option : reader.get_options([](const auto* each) { return each->count() > 0; })) {
    if (!changes_a_picture(option->get_name())) continue;
    words.push_back(option->get_name());
    words.insert(words.end(), option->results().begin(), option->results().end());
  }
  if (!options.output.labels.empty()) words.emplace_back("--labels");  // all agents are posed exactly
  return words;
}

std::optional<std::string> contradiction_of_video(const DemoOptions& options) {
  const int width = options.width, height = options.height;
  if (width % 2 == 0 && height % 2 == 0) return {};
  const auto even = [](int side) { return std::to_string(side + side % 2); };
  return "--video: the sides of a video are even; ask for --size " + even(width) + "x" + even(height);
}

std::optional<std::string> contradiction_of_labels(const DemoOptions& options) {
  if (options.view) return "--labels: are of a crowd; leave out --view";
  if (options.tuning.taken_away != TakenAway{}) return "--labels: need the whole picture; take nothing away";
  if (options.tuning.inspection.split != Split::off) return "--labels: a split view shows two crowds; leave it out";
  if (options.tuning.inspection.freeze_camera) return "--labels: need a camera that is not frozen";
  if (options.tuning.agents > most_labelled_agents) {
    return "--labels: the mask names " + std::to_string(most_labelled_agents) + " agents at most; ask for fewer";
  }
  return {};
}

std::optional<std::string> contradiction_of_output(const DemoOptions& options) {
  const std::string asked = asked_by(options.output);
  const auto refused = [&](const std::string& why) { return asked + ": " + why; };
  if (options.context == ContextKind::window) {
    return refused("a window runs as fast as it is drawn; add --headless");
  }
  if (options.context == ContextKind::none) return refused("--headless=none draws nothing; use --headless");
  if (options.draw && *options.draw != DrawWhich::all) return refused("takes each frame; leave out --draw");
  if (!options.output.video.empty()) {
    if (auto contradiction = contradiction_of_video(options)) return contradiction;
  }
  return options.output.labels.empty() ? std::nullopt : contradiction_of_labels(options);
}

std::optional<std::string> settle_length(const OptionReader& reader, DemoOptions& options) {
  if (!options.output.seconds) return {};
  if (reader.given("--frames")) return "--seconds: --frames says it too; give one of them";
  if (options.context == ContextKind::window) return "--seconds: a window goes by the clock; add --headless";
  const double frames = std::round(*options.output.seconds / options.dt.value_or(usual_frame_seconds));
  if (frames > std::numeric_limits<int>::max()) return "--seconds: so many frames cannot be counted; ask for fewer";
  options.frames = std::max(1, static_cast<int>(frames));
  options.frames_given = true;
  return {};
}

}  // namespace

void declare_output(OptionReader& reader, DemoOptions& options) {
  OutputOptions& output = options.output;
  reader.option_defaults()->group("Every frame of a headless run");
  reader.value("--video", "FILE.mp4|.webm", "Write a video, with the ffmpeg that is installed",
               video_file(output.video));
  reader.value("--fps-out", "N[/N]", "Frames a second of the video; without --dt, of the run too (as the run has)",
               frame_rate(output.frames_per_second, least_rate, most_rate));
  reader.value("--pictures", "DIR", "Write numbered PNGs; keep the ones that are there of the same run",
               folder_name(output.pictures));
  reader.value("--labels", "DIR", "Write where each person is: mask and depth as PNGs, boxes and joints as JSON",
               folder_name(output.labels));
  reader.value("--seconds", "X", "Length of the run, in place of --frames",
               real_number(output.seconds, least_frame_seconds, 1e6));
}

std::optional<std::string> settle_output(const OptionReader& reader, DemoOptions& options) {
  OutputOptions& output = options.output;
  if (output.frames_per_second && output.video.empty()) return "--fps-out: goes with --video";
  if (output.any()) {
    if (auto contradiction = contradiction_of_output(options)) return contradiction;
    output.run = words_of_run(reader, options);
  }
  if (output.frames_per_second && !options.dt && options.replay.empty()) options.dt = 1.0 / *output.frames_per_second;
  if (!output.labels.empty()) {
    const int mesh_lod = options.tuning.mesh_lod;  // a mesh is drawn as it is labelled
    options.tuning = without_level_of_detail(options.tuning);
    options.tuning.mesh_lod = mesh_lod;
  }
  return settle_length(reader, options);
}

}  // namespace throng::app
