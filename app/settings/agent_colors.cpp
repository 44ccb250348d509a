#include "app/settings/agent_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "throng/lod_rules.h"

#include "engine/base/srgb.h"

namespace throng::app {
namespace {

constexpr float first_error_limit = 0.25F;  // pixels; each further step ends at twice as many

constexpr std::uint32_t rgba(std::uint32_t red, std::uint32_t green, std::uint32_t blue, std::uint32_t alpha) {
  return red | green << 8U | blue << 16U | alpha << 24U;
}

// Goes from dark (full detail) to light.
std::uint32_t step_color(int step, int steps) {
  return scale_color(steps <= 1 ? 0.0F
                                : static_cast<float>(std::clamp(step, 0, steps - 1)) / static_cast<float>(steps - 1));
}

std::uint32_t srgb_byte(float linear) { return to_byte(srgb_of_light(linear)); }

std::uint32_t color_of_view(const Tuning& tuning, const AgentDetail& detail) {
  if (const auto scale = color_scale(tuning)) {
    return detail.measure < 0.0F ? 0 : scale_color(detail.measure / scale->top);
  }
  switch (tuning.debug_view) {
    case DebugView::interval:
      return interval_color(detail.interval);
    case DebugView::bone_level:
      return bone_level_color(detail.bone_level);
    case DebugView::mesh_lod:
      return detail.mesh_lod < 0 ? 0 : mesh_lod_color(detail.mesh_lod);
    case DebugView::error:
      return detail.error_px < 0.0F ? 0 : step_color(error_step(detail.error_px), error_steps);
    default:
      return 0;
  }
}

}  // namespace

std::uint32_t interval_color(int frames) { return step_color(frames - 1, interval_steps); }

std::uint32_t bone_level_color(int level) { return step_color(level, max_bone_levels); }
std::uint32_t mesh_lod_color(int lod) { return step_color(lod, mesh_lod_steps); }

float error_limit(int step) { return std::ldexp(first_error_limit, step); }

int error_step(float pixels) {
  int step = 0;
  while (step + 1 < error_steps && pixels >= error_limit(step)) ++step;
  return step;
}

std::optional<ColorScale> color_scale(const Tuning& tuning) {
  constexpr float seconds_a_minute = 60.0F;
  switch (tuning.debug_view) {
    case DebugView::speed:
      return ColorScale{.title = "Speed", .unit = "m/s", .top = tuning.top_speed};
    case DebugView::density:
      return ColorScale{.title = "Density", .unit = "1/m\xC2\xB2", .top = tuning.top_density};
    case DebugView::presence:
      if (tuning.top_presence <= 2.0F * seconds_a_minute) {
        return ColorScale{.title = "Here for", .unit = "s", .top = tuning.top_presence};
      }
      return ColorScale{.title = "Here for", .unit = "min", .top = tuning.top_presence, .a_unit = seconds_a_minute};
    default:
      return std::nullopt;
  }
}

// Viridis by S. van der Walt and N. Smith, at even distances. Its darkest colours are left out, because a shadow would
// make them black.
std::uint32_t scale_color(float share) {
  constexpr std::array<std::array<float, 3>, 8> ramp = {{{71, 39, 119},
                                                         {62, 73, 137},
                                                         {48, 104, 142},
                                                         {37, 133, 142},
                                                         {31, 161, 135},
                                                         {82, 197, 105},
                                                         {165, 219, 54},
                                                         {253, 231, 37}}};
  const float place = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(ramp.size() - 1);
  const std::size_t from = std::min(static_cast<std::size_t>(place), ramp.size() - 2);
  const auto mixed = [&](std::size_t part) {
    const float value = std::lerp(ramp.at(from).at(part), ramp.at(from + 1).at(part), place - static_cast<float>(from));
    return static_cast<std::uint32_t>(std::lround(value));
  };
  return rgba(mixed(0), mixed(1), mixed(2), 255);
}

std::uint32_t debug_color(const Tuning& tuning, const AgentDetail& detail) {
  const std::uint32_t color = color_of_view(tuning, detail);
  return color == 0 && tuning.plain_bodies ? plain_body_color : color;
}

// The colours and their order are as in color_of_weight in shaders/crowd_vertex_main.glsl, which are linear.
std::uint32_t weight_color(float weight) {
  constexpr std::array<std::array<float, 3>, 3> ramp = {
      {{0.02F, 0.04F, 0.2F}, {0.05F, 0.4F, 0.15F}, {1.0F, 0.8F, 0.05F}}};
  const float place = 2.0F * std::clamp(weight, 0.0F, 1.0F);
  const std::size_t from = place < 1.0F ? 0 : 1;
  const auto mixed = [&](std::size_t part) {
    return srgb_byte(std::lerp(ramp.at(from).at(part), ramp.at(from + 1).at(part), place - static_cast<float>(from)));
  };
  return rgba(mixed(0), mixed(1), mixed(2), 255);
}

}  // namespace throng::app
