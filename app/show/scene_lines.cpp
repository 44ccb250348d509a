#include "app/show/scene_lines.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/settings/agent_colors.h"

namespace throng::app {
namespace {

constexpr std::uint32_t frustum_color = 0xFFF2F0E8, opaque = 0xFF000000;
constexpr float ground = 0.03F;  // metres: just above, so that paving does not cover it
constexpr int ring_corners = 96;

glm::vec3 crossing(const glm::vec3& from, const glm::vec3& to) {
  return glm::mix(from, to, (ground - from.y) / (to.y - from.y));
}

bool crosses(const glm::vec3& from, const glm::vec3& to) { return (from.y < ground) != (to.y < ground); }

void add_above_ground(SceneLines& lines, glm::vec3 from, glm::vec3 to) {
  if (from.y < ground && to.y < ground) return;
  if (crosses(from, to)) (from.y < ground ? from : to) = crossing(from, to);
  lines.push_back({from, to, frustum_color});
}

// Where a flat polygon stands in the ground.
void add_trace(SceneLines& lines, std::span<const glm::vec3> polygon) {
  std::optional<glm::vec3> first;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    if (!crosses(from, to)) continue;
    if (first) lines.push_back({*first, crossing(from, to), frustum_color});
    first = crossing(from, to);
  }
}

std::array<glm::vec3, 4> corners_at(const render::Camera& camera, float aspect, float metres) {
  const float up = metres * std::tan(camera.vertical_view / 2), side = up * aspect;
  const glm::vec3 ahead = render::forward(camera), right = render::right(camera), above = glm::cross(right, ahead);
  const glm::vec3 middle = camera.position + metres * ahead;
  return {middle - side * right - up * above, middle + side * right - up * above, middle + side * right + up * above,
          middle - side * right + up * above};
}

}  // namespace

void add_frustum(SceneLines& lines, const render::Camera& camera, float aspect, float reach) {
  const std::array<glm::vec3, 4> near = corners_at(camera, aspect, 1.0F), far = corners_at(camera, aspect, reach);
  for (std::size_t i = 0; i < far.size(); ++i) {
    const std::size_t next = (i + 1) % far.size();
    add_above_ground(lines, camera.position, far[i]);
    add_above_ground(lines, near[i], near[next]);
    add_above_ground(lines, far[i], far[next]);
    add_trace(lines, std::array{camera.position, far[i], far[next]});
  }
  add_trace(lines, far);
}

void add_threshold_rings(SceneLines& lines, std::span<const IntervalThreshold> thresholds, const render::Camera& camera,
                         float height) {
  const float above = camera.position.y - height;
  for (const IntervalThreshold& threshold : thresholds) {
    const float squared = threshold.metres * threshold.metres - above * above;
    if (squared <= 0) continue;
    const float radius = std::sqrt(squared);
    const auto corner = [&](int i) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / ring_corners;
      return glm::vec3(camera.position.x + radius * std::sin(angle), ground,
                       camera.position.z + radius * std::cos(angle));
    };
    const std::uint32_t color = interval_color(threshold.interval) | opaque;
    for (int i = 0; i < ring_corners; ++i) lines.push_back({corner(i), corner(i + 1), color});
  }
}

}  // namespace throng::app
