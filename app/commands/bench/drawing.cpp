#include "app/commands/bench/drawing.h"

#include <array>
#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/bench/plot.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/files/progress_line.h"
#include "app/settings/choices.h"
#include "app/show/figures/statistics.h"
#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

using Clock = std::chrono::steady_clock;
using PartOfFrame = double (*)(const FrameTimes&);

constexpr int warm_up_frames = 20;            // until levels of detail have learnt from errors
constexpr double share_of_warming_up = 0.25;  // of the seconds

/// The parts of a frame, in the order in which they happen.
struct NamedPart {
  const char* key;
  const char* name;  ///< in the plot
  PartOfFrame milliseconds;
};
constexpr std::array<NamedPart, 7> parts = {
    {{"frame_ms_median", "frame", [](const FrameTimes& times) { return times.frame_ms(); }},
     {"crowd_ms_median", "crowd", [](const FrameTimes& times) { return times.stage.crowd_ms; }},
     {"cull_ms_median", "cull", [](const FrameTimes& times) { return times.stage.selection_ms; }},
     {"pose_ms_median", "pose", [](const FrameTimes& times) { return times.stage.pose_ms; }},
     {"upload_ms_median", "upload", [](const FrameTimes& times) { return times.upload_ms; }},
     {"submission_ms_median", "submission", [](const FrameTimes& times) { return times.submission_ms; }},
     {"wait_ms_median", "wait for the device", [](const FrameTimes& times) { return times.wait_ms; }}}};

/// Draws frames of one show until there are enough or its time is over.
class DrawnFrames {
 public:
  DrawnFrames(Show& show, const BenchOptions& options) : show_(&show), options_(&options) {}

  Status run() {
    for (int frame = 0; frame < warm_up_frames && seconds() < share_of_warming_up * most_seconds(); ++frame) {
      if (Status drawn = draw(); !drawn) return drawn;
    }
    while (static_cast<int>(frames_.size()) < options_->frames) {
      if (Status drawn = draw(); !drawn) return drawn;
      frames_.push_back(show_->figures().times());
      if (seconds() > most_seconds()) break;
    }
    return Done{};
  }

  Json figures() const {
    Json row = {{"agents", show_->stage().crowd().size()},
                {"agents_in_view", show_->stage().posed().selection().visible.size()},
                {"frames", frames_.size()},
                {"stopped", static_cast<int>(frames_.size()) < options_->frames}};
    for (const NamedPart& part : parts) {
      std::vector<double> times;
      for (const FrameTimes& frame : frames_) times.push_back(part.milliseconds(frame));
      row[part.key] = median(std::move(times));
    }
    row["device_ms_median"] = device_median();
    row["triangles"] = show_->painter().draw_counts().triangles;
    row["draw_calls"] = show_->painter().draw_counts().draw_calls;
    return row;
  }

 private:
  Status draw() {
    show_->animate(ticks_per_second / 60);
    return show_->draw();
  }
  double most_seconds() const { return static_cast<double>(options_->seconds); }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  Json device_median() const {
    std::vector<double> times;
    for (const FrameTimes& frame : frames_) {
      if (frame.device_ms) times.push_back(*frame.device_ms);
    }
    return times.empty() ? Json(nullptr) : Json(median(std::move(times)));
  }

  Show* show_;
  const BenchOptions* options_;
  std::vector<FrameTimes> frames_;
  Clock::time_point start_ = Clock::now();
};

DemoOptions shown_options(const BenchOptions& options, int agents) {
  DemoOptions shown = options.shown;
  if (!options.model.empty()) shown.models = {options.model};
  shown.tuning.agents = agents;
  shown.tuning.system.pus = options.pus.front();
  shown.values_given.keys.emplace_back("agents");
  shown.draw = DrawWhich::all;
  shown.kernels = options.kernels;
  shown.data = options.data;
  shown.reading = options.reading;
  if (shown.context == ContextKind::window) shown.context = ContextKind::headless_default;
  return shown;
}

/// Describes the device and the show.
Json description(const Show& show, const DemoOptions& shown) {
  const DrawnBy drawn_by = show.painter().drawn_by();
  const DeviceChoices& chosen = show.painter().device_choices();
  const Tuning& tuning = show.stage().tuning();
  return {{"device", drawn_by.gl_renderer},
          {"gl_version", drawn_by.gl_version},
          {"context", drawn_by.context},
          {"is_software", show.painter().is_on_software()},
          {"pus", show.stage().system().options().pus},
          {"size", std::vector<Json>{shown.width, shown.height}},
          {"samples", shown.msaa >= 0 ? shown.msaa : (chosen.no_multisampling ? 0 : 4)},
          {"shadows", tuning.shadows},
          {"crowd_shade", tuning.crowd_shade},
          {"scenery", tuning.scenery},
          {"model", show.stage().people().front().name},
          {"scene", word_of(tuning.scene)},
          {"camera", shown.camera_name.empty() && !shown.camera ? "front" : shown.camera_name},
          {"error_px", tuning.error_px}};
}

/// Says in words which show was drawn, from where and how.
std::string drawn_things(const Json& described) {
  const auto text = [&](const char* key) { return described[key].get<std::string>(); };
  const bool samples = described["samples"].get<int>() > 0;
  const std::span<const Json> size = described["size"].elements();
  return size[0].dump() + "x" + size[1].dump() + ", " + (samples ? "4 samples a pixel" : "one sample a pixel") +
         (described["shadows"].get<bool>() ? ", shadows" : ", no shadows") +
         (described["scenery"].get<bool>() ? ", scenery" : ", no scenery") + ", " + text("model") + ", scene " +
         text("scene") + ", camera " + text("camera") + ", " + described["pus"].dump() + " PUs";
}

std::string heading(const Json& described) {
  const auto text = [&](const char* key) { return described[key].get<std::string>(); };
  return text("device") + " (" + text("context") + ", OpenGL " + text("gl_version") + ")\n" + drawn_things(described) +
         "\n";
}

std::string remarks(const Json& described, const std::vector<Json>& rows, const BenchOptions& options) {
  std::string text;
  if (described["is_software"].get<bool>()) {
    text += "The device is a processor, which has no clock of its own: it draws in submission_ms and wait_ms.\n";
  }
  for (const Json& row : rows) {
    if (!row["stopped"].get<bool>()) continue;
    text += row["agents"].dump() + " agents were stopped after " + Json(options.seconds).dump() + " s, at " +
            row["frames"].dump() + " of " + std::to_string(options.frames) + " frames.\n";
  }
  return text;
}

std::string plot_of(const Json& described, const std::vector<Json>& rows) {
  std::vector<PlotLine> lines;
  const auto add = [&](const char* key, const char* name) {
    PlotLine line{.name = name, .x = {}, .y = {}, .dashed = false};
    for (const Json& row : rows) {
      if (!row[key].is_number()) continue;
      line.x.push_back(row["agents"].get<double>());
      line.y.push_back(row[key].get<double>());
    }
    if (!line.x.empty()) lines.push_back(std::move(line));
  };
  for (const NamedPart& part : parts) add(part.key, part.name);
  add("device_ms_median", "device, by its own clock");
  return lines_as_svg("What a frame costs on " + described["device"].get<std::string>(), "agents", "ms a frame", lines,
                      {.logarithmic = true, .note = drawn_things(described)});
}

constexpr std::array drawn_columns = {
    "agents",           "agents_in_view", "frames",           "frame_ms_median",      "crowd_ms_median",
    "cull_ms_median",   "pose_ms_median", "upload_ms_median", "submission_ms_median", "wait_ms_median",
    "device_ms_median", "triangles",      "draw_calls"};

}  // namespace

std::vector<int> usual_drawn_agents() { return {1000, 3000, 10'000, 30'000, 100'000}; }

Result<BenchReport> measure_drawing(const BenchOptions& options) {
  Json described;
  std::vector<Json> rows;
  for (const int agents : options.agents) {
    show_progress(std::to_string(agents) + " agents");
    const DemoOptions shown = shown_options(options, agents);
    StartError error;
    const std::unique_ptr<Show> show = open_show(shown, error);
    if (show == nullptr) return Error{error.message};
    show->painter().time_device();
    DrawnFrames frames(*show, options);
    if (const Status drawn = frames.run(); !drawn) return drawn.error();
    described = description(*show, shown);
    rows.push_back(frames.figures());
  }
  show_progress("");
  const std::string plot = plot_of(described, rows);
  std::string text = heading(described) + figures_as_text(rows, drawn_columns) + remarks(described, rows, options);
  described["seconds"] = options.seconds;
  described["rows"] = rows;
  return BenchReport{.text = std::move(text), .json = std::move(described), .plot = plot};
}

}  // namespace throng::app
