#include "engine/render/light/cascades.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace throng::render {
namespace {

constexpr float nearest_of_all = 0.25F, farthest_of_all = 1600.0F;  // metres
constexpr DepthRange depths_of_people{0.5F, 60.0F};
constexpr float room = 3.0F;        // metres that people reach beyond the place where they stand
constexpr float depth_step = 1.5F;  // depths are rounded to powers of it
constexpr float evenness = 0.12F;   // 0: slices grow by a factor, 1: all are equally deep
constexpr float margin = 1.04F;     // a map is larger than its ball, for soft edges

float rounded_down(float depth) { return std::pow(depth_step, std::floor(std::log(depth) / std::log(depth_step))); }

float slice_end(const DepthRange& depths, int slice) {
  const float share = static_cast<float>(slice) / cascade_count;
  const float grown = depths.nearest * std::pow(depths.farthest / depths.nearest, share);
  return glm::mix(grown, glm::mix(depths.nearest, depths.farthest, share), evenness);
}

struct Ball {
  float depth = 0.0F;  // of its centre, which is on the camera's axis
  float radius = 0.0F;
};

/// Returns the smallest ball around a slice of the frustum. `slope` is the slope of the frustum's edges.
Ball ball_around(float from, float to, float slope) {
  const float squared = slope * slope;
  if (squared * (from + to) >= to - from) return {to, to * slope};
  const float depth = 0.5F * (from + to) * (1.0F + squared);
  return {depth, std::hypot(to - depth, to * slope)};
}

glm::vec3 axis_of(const CameraView& camera) {
  return -glm::vec3(camera.view[0][2], camera.view[1][2], camera.view[2][2]);
}

/// Moves a ball to a whole number of texels along the sides of its map.
glm::vec3 snapped(const glm::vec3& centre, const SunAxes& axes, float texel) {
  const auto moved = [&](const glm::vec3& axis) {
    const float along = glm::dot(centre, axis);
    return axis * (std::floor(along / texel) * texel - along);
  };
  return centre + moved(axes.x) + moved(axes.y);
}

glm::mat4 clip_matrix(const Cascade& cascade, const SunAxes& axes) {
  const float scale = 1.0F / (cascade.radius * margin);
  const auto row = [&](const glm::vec3& axis, float times, float plus) {
    return glm::vec4(axis * times, plus - times * glm::dot(axis, cascade.centre));
  };
  const glm::vec4 x = row(axes.x, scale, 0.0F), y = row(axes.y, scale, 0.0F), z = row(axes.z, -0.5F * scale, 0.5F);
  return {{x.x, y.x, z.x, 0.0F}, {x.y, y.y, z.y, 0.0F}, {x.z, y.z, z.z, 0.0F}, {x.w, y.w, z.w, 1.0F}};
}

}  // namespace

DepthRange depths_of(const CrowdFrame& frame) {
  if (frame.instances.empty()) return depths_of_people;
  const glm::vec3 axis = axis_of(frame.camera);
  const float origin = glm::dot(axis, frame.camera.position);
  DepthRange depths{farthest_of_all, nearest_of_all};
  for (const InstanceRecord& record : frame.instances) {
    const float depth =
        axis.x * record.position[0] + axis.y * record.position[1] + axis.z * record.position[2] - origin;
    depths.nearest = std::min(depths.nearest, depth);
    depths.farthest = std::max(depths.farthest, depth);
  }
  const float reach = room * frame.distance_scale;
  depths.nearest = std::clamp(depths.nearest - reach, nearest_of_all, farthest_of_all / 2.0F);
  depths.farthest = std::clamp(depths.farthest + reach, 8.0F * depths.nearest, farthest_of_all);
  return {rounded_down(depths.nearest), rounded_down(depths.farthest) * depth_step};
}

SunAxes sun_axes(const glm::vec3& to_sun) {
  const glm::vec3 beside = std::abs(to_sun.y) < 0.99F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(0.0F, 0.0F, 1.0F);
  const glm::vec3 x = glm::normalize(glm::cross(beside, to_sun));
  return {x, glm::cross(to_sun, x), to_sun};
}

std::array<Cascade, cascade_count> plan_cascades(const CameraView& camera, const SunAxes& axes,
                                                 const DepthRange& depths, int side) {
  const float slope = std::hypot(1.0F / camera.projection[0][0], 1.0F / camera.projection[1][1]);
  const glm::vec3 axis = axis_of(camera);
  std::array<Cascade, cascade_count> cascades;
  for (int i = 0; i < cascade_count; ++i) {
    Cascade& cascade = cascades.at(static_cast<std::size_t>(i));
    cascade.reach = slice_end(depths, i + 1);
    const Ball ball = ball_around(slice_end(depths, i), cascade.reach, slope);
    cascade.radius = ball.radius;
    cascade.texel = 2.0F * ball.radius * margin / static_cast<float>(side);
    cascade.centre = snapped(camera.position + axis * ball.depth, axes, cascade.texel);
    cascade.to_clip = clip_matrix(cascade, axes);
  }
  return cascades;
}

CastLimits cast_limits(const std::array<Cascade, cascade_count>& cascades, const SunAxes& axes,
                       const std::array<bool, cascade_count>& wanted) {
  CastLimits limits;
  for (std::size_t i = 0; i < cascade_count; ++i) {
    const glm::vec3 middle = axes.along(cascades.at(i).centre);
    limits.x.at(i) = middle.x;
    limits.y.at(i) = middle.y;
    limits.z.at(i) = middle.z;
    limits.reach.at(i) = wanted.at(i) ? cascades.at(i).radius * margin : -std::numeric_limits<float>::infinity();
  }
  return limits;
}

}  // namespace throng::render
