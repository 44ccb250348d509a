#include "app/show/crowd_framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/show/stage/stage.h"
#include "app/show/track_cameras.h"

namespace throng::app {
namespace {

constexpr float least_ahead = 1.05F * render::Camera::near_distance;  // a nearer box is not drawn

/// Finds where a camera sees all points along one axis of the picture. It sees between two planes through it; each
/// leans to the side by so much a metre ahead. Each point must lie between them, which bounds the place of the camera
/// twice.
class SeenAcross {
 public:
  SeenAcross(float low, float high) : low_(low), high_(high) {}

  void add(float aside, float ahead) {
    most_ = std::min(most_, aside - low_ * ahead);
    least_ = std::max(least_, aside - high_ * ahead);
  }
  /// Returns how far ahead the camera may be so that it can see all.
  float farthest_ahead() const { return (most_ - least_) / (high_ - low_); }
  /// Returns where the camera is aside, in the middle of where it may be when it is that far ahead.
  float aside(float ahead) const { return 0.5F * (most_ + low_ * ahead + least_ + high_ * ahead); }

 private:
  float low_, high_;
  float most_ = std::numeric_limits<float>::max(), least_ = std::numeric_limits<float>::lowest();
};

PicturePart without_margin(const PicturePart& part) {
  const float across = framing_margin * (part.right - part.left), along = framing_margin * (part.bottom - part.top);
  return {
      .left = part.left + across, .top = part.top + along, .right = part.right - across, .bottom = part.bottom - along};
}

glm::vec3 corner_of(const FramedBox& box, unsigned corner) {
  return {(corner & 1U) != 0 ? box.high.x : box.low.x, (corner & 2U) != 0 ? box.high.y : box.low.y,
          (corner & 4U) != 0 ? box.high.z : box.low.z};
}

}  // namespace

render::Camera framed(const render::Camera& camera, std::span<const FramedBox> boxes, float aspect,
                      const PicturePart& part) {
  constexpr unsigned corners = 8;
  const glm::vec3 ahead = render::forward(camera), right = render::right(camera), up = glm::cross(right, ahead);
  const float tall = std::tan(camera.vertical_view * 0.5F), wide = tall * aspect;
  const PicturePart free = without_margin(part);
  SeenAcross across(wide * (2.0F * free.left - 1.0F), wide * (2.0F * free.right - 1.0F));
  SeenAcross along(tall * (1.0F - 2.0F * free.bottom), tall * (1.0F - 2.0F * free.top));
  // Distances from the middle of a box, so that they keep their precision far from the origin.
  const glm::vec3 origin = 0.5F * (boxes.front().low + boxes.front().high);
  float nearest = std::numeric_limits<float>::max();
  for (const FramedBox& box : boxes) {
    for (unsigned corner = 0; corner < corners; ++corner) {
      const glm::vec3 way = corner_of(box, corner) - origin;
      const float depth = glm::dot(way, ahead);
      across.add(glm::dot(way, right), depth);
      along.add(glm::dot(way, up), depth);
      nearest = std::min(nearest, depth);
    }
  }
  const float depth = std::min({across.farthest_ahead(), along.farthest_ahead(), nearest - least_ahead});
  render::Camera moved = camera;
  moved.position = origin + across.aside(depth) * right + along.aside(depth) * up + depth * ahead;
  return moved;
}

std::vector<FramedBox> boxes_of(const Stage& stage) {
  if (const FollowedTracks* const tracks = stage.crowd().tracks()) {
    return {box_of(tracks->people(), static_cast<float>(stage.crowd().laid_out_for().height))};
  }
  std::vector<FramedBox> boxes;
  const auto agents = static_cast<std::uint32_t>(stage.crowd().size());
  boxes.reserve(agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    const UprightBody body = body_of(stage, agent);
    const anim::CharacterBounds& bounds = stage.character_of(agent).character->bounds;
    const float reach = stage.crowd().scales()[agent] * static_cast<float>(bounds.reach);
    const glm::vec3 beside(reach, 0.0F, reach), up(0.0F, 0.5F * body.height + reach, 0.0F);
    boxes.push_back({.low = body.foot - beside, .high = body.foot + beside + up});
  }
  return boxes;
}

}  // namespace throng::app
