#include "app/people/crowd/stride_plane.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::app {
namespace {

constexpr double most_cycles_per_second = 2.2;  // of a sprinter: a faster agent slides
constexpr float standing = 1e-3F;               // metres a second
constexpr float steps_from = 0.12F;             // metres a second; a slower agent stands in part
constexpr float least_stride = 1e-3F;           // metres

anim::BlendPlane plane_of(std::span<const StridePoint> points) {
  std::vector<glm::vec2> places;
  for (const StridePoint& point : points) places.push_back(point.gait.velocity);
  auto plane = anim::BlendPlane::create(places);
  assert(plane && "no two gaits of a character have one velocity");
  return std::move(*plane);
}

/// Keeps the smallest speed that is not 0.
void keep_slower(float& slowest, float speed) { slowest = slowest > 0.0F ? std::min(slowest, speed) : speed; }

}  // namespace

StridePlane::StridePlane(std::vector<StridePoint> points) : points_(std::move(points)), plane_(plane_of(points_)) {
  for (const StridePoint& point : std::span(points_).subspan(1)) {
    const glm::vec2 velocity = point.gait.velocity;
    if (std::abs(velocity.x) > std::abs(velocity.y)) {
      keep_slower(slowest_aside_, std::abs(velocity.x));
    } else {
      keep_slower(velocity.y > 0.0F ? slowest_ahead_ : slowest_back_, std::abs(velocity.y));
    }
  }
}

// The slowest gait of any direction lies on an ellipse through the slowest gaits ahead and aside.
float StridePlane::slowest(const glm::vec2& direction) const {
  const float along = direction.y >= 0.0F ? slowest_ahead_ : slowest_back_;
  if (along <= 0.0F || slowest_aside_ <= 0.0F) return std::max(along, slowest_aside_);
  return 1.0F / glm::length(direction / glm::vec2(slowest_aside_, along));
}

StridePlane::Stride StridePlane::stride(const glm::vec2& velocity) const {
  const float speed = glm::length(velocity);
  if (speed < standing) return {.shares = plane_.shares(glm::vec2(0.0F))};
  const glm::vec2 direction = velocity / speed;
  const float least = slowest(direction);
  const float shown = speed < least ? std::sqrt(speed * least) : speed;
  Stride stride{.shares = plane_.shares(direction * shown)};
  glm::vec2 metres(0.0F);
  for (const auto& share : stride.shares.all()) {
    metres += share.weight * points_[share.point].gait.velocity * static_cast<float>(points_[share.point].seconds);
  }
  const float length = std::max(glm::length(metres), least_stride);
  stride.stands = 1.0F - glm::smoothstep(0.0F, steps_from, speed);
  stride.cycles_per_second = std::min(static_cast<double>(speed / length), most_cycles_per_second);
  return stride;
}

}  // namespace throng::app
