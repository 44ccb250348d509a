#include "app/window/drawn_overlay.h"

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "app/files/data_folder.h"
#include "app/files/json_file.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/painter.h"
#include "app/show/stage/stage.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

// The tile, as it was swept once.
SweepCurve sweep_in(std::span<const Json> stops, std::optional<std::string>& complaint) {
  SweepCurve sweep{.value = SweptValue::tile, .stops = {}, .refusal = {}};
  for (const Json& each : stops) {
    const std::string name = "stop " + std::to_string(sweep.stops.size());
    const JsonObject reader(name, each, {"tile", "update_ms", "tasks", "bytes"}, complaint);
    auto& stop = sweep.stops.emplace_back();
    stop.known = true;
    reader.number("tile", stop.value);
    reader.number("update_ms", stop.cost.milliseconds);
    reader.read("tasks", stop.cost.tasks, "a whole number");
    reader.read("bytes", stop.cost.bytes, "a whole number");
  }
  return sweep;
}

/// Replaces the figures that this machine measured by a committed report's, so that pictures can be compared.
/// Errors: the file cannot be read, or is no JSON object.
Status fix_measured(const std::filesystem::path& report_file, FrameReport& report) {
  const JsonFile file(report_file, {.wrong = "it holds the measured figures that --ui=fixed shows"});
  const auto json = file.read();
  if (!json) return json.error();
  std::optional<std::string> complaint;
  const JsonObject reader(
      "", *json,
      {"frame_ms", "update_ms", "draw_ms", "frame_ms_history", "update_ms_history", "context", "gl_version",
       "gl_renderer", "simd_target", "hardware_threads", "limit_sentence", "pu_busy_ms", "sweep"},
      complaint);
  FrameReport fixed = report;
  reader.read("frame_ms", fixed.frame_ms, "a number");
  reader.read("update_ms", fixed.update_ms, "a number");
  reader.read("draw_ms", fixed.draw_ms, "a number");
  reader.read("frame_ms_history", fixed.frame_ms_history, "an array of numbers");
  reader.read("update_ms_history", fixed.update_ms_history, "an array of numbers");
  reader.text("context", fixed.context);
  reader.text("gl_version", fixed.gl_version);
  reader.text("gl_renderer", fixed.gl_renderer);
  reader.text("simd_target", fixed.simd_target);
  reader.whole("hardware_threads", fixed.hardware_threads, 0, 65536);
  reader.text("limit_sentence", fixed.limit_sentence);
  double busy_ms = 0;
  reader.number("pu_busy_ms", busy_ms);
  for (PuReport& pu : fixed.pu) pu.activity.busy_ms = busy_ms;
  if (reader.has("sweep")) fixed.sweep = sweep_in(reader.elements("sweep"), complaint);
  if (complaint) return file.wrong(*complaint);
  fixed.timeline.clear();
  fixed.kept = {};
  fixed.error.skipping_sentence.clear();  // it has measured times
  report = std::move(fixed);
  return Done{};
}

}  // namespace

Status DrawnOverlay::begin(Show& show) {
  tuning_ = show.stage().tuning();
  reporter_.emplace(show);
  if (Status reported = report(show); !reported) return reported;
  overlay_ = std::make_unique<Overlay>(fonts_folder(options_.data), options_.ui_scale, tuning_);
  overlay_->show_tab(options_.ui_tab);
  overlay_->set_hidden(!options_.ui);
  if (options_.legend) overlay_->show_legend_only();
  if (Status prepared = show.painter().renderer().prepare_overlay(); !prepared) return prepared;
  constexpr int frames_until_laid_out = 29;  // three would do; the more, the truer the time of one
  for (int frame = 0; frame < frames_until_laid_out; ++frame) build(show);
  return Done{};
}

Status DrawnOverlay::report(Show& show) {
  const FrameTimes& times = show.figures().times();
  reporter_->update(show, place_of(show.view().camera), times.animation_ms + times.drawing_ms());
  if (!options_.ui_fixed) return Done{};
  const auto figures = find_data(data_folders(options_.data), "assets/fixed_report.json");
  return figures ? fix_measured(*figures, reporter_->report()) : Status(figures.error());
}

void DrawnOverlay::build(Show& show) {
  StopWatch watch;
  tuning_ = show.stage().tuning();
  overlay_->begin_frame(show.view().width, show.view().height, options_.dt.value_or(usual_frame_seconds), {});
  overlay_->build(reporter_->report(), tuning_);
  show.figures().add_overlay(watch.lap());
}

Status DrawnOverlay::draw(Show& show) {
  if (Status reported = overlay_ == nullptr ? begin(show) : report(show); !reported) return reported;
  build(show);
  show.painter().renderer().draw_overlay(*overlay_->draw_data());
  return Done{};
}

Status DrawnOverlay::write_map() const {
  if (options_.ui_map.empty() || overlay_ == nullptr) return Done{};
  return write_whole_file(options_.ui_map, to_json(overlay_->ui_map(), tuning_, reporter_->report()));
}

}  // namespace throng::app
