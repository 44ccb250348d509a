#include "app/demo/fixed_report.h"

#include <fstream>
#include <vector>

#include <nlohmann/json.hpp>

namespace throng::app {
namespace {

// Of the tile, as it was swept once.
SweepCurve sweep_in(const nlohmann::json& stops) {
  SweepCurve sweep{.value = SweptValue::tile, .stops = {}, .refusal = {}};
  for (const nlohmann::json& stop : stops) {
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
  std::ifstream stream(report_file);
  const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object()) {
    return anim::Error{report_file.string() + ": not the JSON object of measured figures that --ui=fixed shows"};
  }
  report.frame_ms = json.value("frame_ms", 0.0F);
  report.update_ms = json.value("update_ms", 0.0F);
  report.draw_ms = json.value("draw_ms", 0.0F);
  report.frame_ms_history = json.value("frame_ms_history", std::vector<float>{});
  report.update_ms_history = json.value("update_ms_history", std::vector<float>{});
  report.context = json.value("context", "");
  report.gl_version = json.value("gl_version", "");
  report.gl_renderer = json.value("gl_renderer", "");
  report.simd_target = json.value("simd_target", "");
  report.hardware_threads = json.value("hardware_threads", 0);
  report.limit_sentence = json.value("limit_sentence", "");
  const float busy_ms = json.value("pu_busy_ms", 0.0F);
  for (PuReport& pu : report.pu) {
    pu.busy_ms = busy_ms;
    pu.wait_ms = 0;
    pu.spans.clear();
  }
  report.timeline.clear();
  if (json.contains("sweep")) report.sweep = sweep_in(json["sweep"]);
  return anim::Done{};
}

}  // namespace throng::app
