#include "app/settings/agent_colors.h"

#include <algorithm>
#include <array>

#include "engine/anim/lod/lod.h"

namespace throng::app {
namespace {

constexpr std::uint32_t rgba(std::uint32_t red, std::uint32_t green, std::uint32_t blue, std::uint32_t alpha) {
  return red | green << 8U | blue << 16U | alpha << 24U;
}

}  // namespace

std::uint32_t step_color(int step, int steps) {
  constexpr std::array<std::uint32_t, 6> row = {rgba(70, 200, 120, 200), rgba(150, 205, 80, 200),
                                                rgba(235, 205, 70, 200), rgba(240, 150, 60, 200),
                                                rgba(230, 90, 70, 200),  rgba(190, 60, 120, 200)};
  const int last = static_cast<int>(row.size()) - 1;
  const int place = steps <= 1 ? 0 : std::clamp(step, 0, steps - 1) * last / (steps - 1);
  return row[static_cast<std::size_t>(place)];
}

int error_step(float pixels) {
  int step = 0;
  for (float limit = 0.25F; step + 1 < error_steps && pixels >= limit; limit *= 2.0F) ++step;
  return step;
}

std::uint32_t debug_color(DebugView view, const AgentDetail& detail) {
  switch (view) {
    case DebugView::interval:
      return step_color(detail.interval - 1, 8);
    case DebugView::bone_level:
      return step_color(detail.bone_level, anim::max_bone_levels);
    case DebugView::error:
      return detail.error_px < 0.0F ? 0 : step_color(error_step(detail.error_px), error_steps);
    case DebugView::none:
    case DebugView::mesh_lod:
      return 0;
  }
  return 0;
}

}  // namespace throng::app
