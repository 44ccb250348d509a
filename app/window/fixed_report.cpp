#include "app/window/fixed_report.h"

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "app/files/json_file.h"
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

}  // namespace

anim::Status fix_measured(const std::filesystem::path& report_file, FrameReport& report) {
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
  return anim::Done{};
}

}  // namespace throng::app
