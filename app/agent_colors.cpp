#include "app/agent_colors.h"

#include <algorithm>
#include <array>

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

std::uint32_t debug_color(DebugView view, const anim::VisibleAgent& agent, int bone_level) {
  switch (view) {
    case DebugView::interval:
      return step_color(agent.interval - 1, 8);
    case DebugView::bone_level:
      return step_color(bone_level, anim::most_bone_levels);
    case DebugView::none:
    case DebugView::mesh_lod:
      return 0;
  }
  return 0;
}

}  // namespace throng::app
