#include "engine/anim/bake/ground_speed.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "engine/anim/bake/surface.h"

namespace throng::anim {

namespace {

constexpr double least_speed = 0.25;    // metres a second
constexpr double least_agreeing = 0.5;  // of the stance samples
constexpr std::size_t least_stances = stride_instants / 10;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Returns the ground-plane velocities of the lowest joint while it is on the ground.
std::vector<glm::dvec2> stance_velocities(const Stride& stride) {
  std::vector<glm::dvec2> velocities;
  for (std::size_t i = 0; i < stride_instants; ++i) {
    const std::size_t lowest = stride.lowest(i, stride.feet);
    if (stride.is_low(i, lowest)) velocities.push_back(stride.velocity(i, lowest));
  }
  return velocities;
}

glm::dvec2 median(std::span<const glm::dvec2> velocities) {
  std::vector<double> x;
  std::vector<double> z;
  for (const glm::dvec2& velocity : velocities) {
    x.push_back(velocity.x);
    z.push_back(velocity.y);
  }
  return {median(std::move(x)), median(std::move(z))};
}

}  // namespace

glm::dvec2 stance_velocity(const Stride& stride) {
  constexpr glm::dvec2 none(0.0);
  if (stride.feet.empty()) return none;
  const std::vector<glm::dvec2> velocities = stance_velocities(stride);
  if (velocities.size() < least_stances) return none;
  const glm::dvec2 typical = median(velocities);
  if (glm::length(typical) < least_speed * stride.size) return none;
  const auto agreeing =
      std::ranges::count_if(velocities, [&](const glm::dvec2& velocity) { return agrees(velocity, typical); });
  const double share = static_cast<double>(agreeing) / static_cast<double>(velocities.size());
  return share < least_agreeing ? none : typical;
}

glm::dvec2 travel_velocity(const RootCurve& curve) {
  const RootVelocity start = root_velocity(curve, 0);
  const glm::dvec2 velocity(start.linear.x, start.linear.z);
  constexpr double least_arc = 0.25;  // metres a second: a body that turns on the spot shifts its weight
  if (start.yaw != 0.0) return glm::length(velocity) < least_arc ? glm::dvec2(0.0) : velocity;
  const glm::dvec3 travel = whole_motion(curve).translation;
  return glm::dvec2(travel.x, travel.z) / to_seconds(curve.duration);
}

}  // namespace throng::anim
