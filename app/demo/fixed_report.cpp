#include "app/demo/fixed_report.h"

#include <vector>

#include "app/files/json_file.h"

namespace throng::app {
namespace {

// Of the tile, as it was swept once.
SweepCurve sweep_in(const Json& stops) {
  SweepCurve sweep{.value = SweptValue::tile, .stops = {}, .refusal = {}};
  for (const Json& stop : stops.elements()) {
    sweep.stops.push_back({.value = stop.value("tile", 0.0),
                           .known = true,
                           .cost = {.milliseconds = stop.value("update_ms", 0.0),
                                    .tasks = stop.value("tasks", std::uint64_t{0}),
                                    .bytes = stop.value("bytes", std::uint64_t{0})}});
  }
  return sweep;
}

}  // namespace

anim::Status fix_measured(const std::filesystem::path& report_file, FrameReport& report) {
  const JsonFile file(report_file);
  const auto read = file.read();
  if (!read || !read->is_object()) {
    return file.wrong("not the JSON object of measured figures that --ui=fixed shows");
  }
  const Json& json = *read;
  report.frame_ms = json.value("frame_ms", 0.0F);
  report.update_ms = json.value("update_ms", 0.0F);
  report.draw_ms = json.value("draw_ms", 0.0F);
  report.frame_ms_history = json.value("frame_ms_history", std::vector<float>{});
  report.update_ms_history = json.value("update_ms_history", std::vector<float>{});
  report.context = json.value("context", std::string());
  report.gl_version = json.value("gl_version", std::string());
  report.gl_renderer = json.value("gl_renderer", std::string());
  report.simd_target = json.value("simd_target", std::string());
  report.hardware_threads = json.value("hardware_threads", 0);
  report.limit_sentence = json.value("limit_sentence", std::string());
  for (PuReport& pu : report.pu) pu.activity.busy_ms = json.value("pu_busy_ms", 0.0);
  report.timeline.clear();
  if (json.contains("sweep")) report.sweep = sweep_in(json["sweep"]);
  return anim::Done{};
}

}  // namespace throng::app
