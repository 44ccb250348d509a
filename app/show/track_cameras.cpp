#include "app/show/track_cameras.h"

#include <array>

#include <glm/geometric.hpp>

#include "app/show/camera/fly_camera.h"

namespace throng::app {
namespace {

constexpr float plan_field_of_view = 4.0F;  // degrees
constexpr float highest_camera = 0.5F * render::Camera::far_distance;

struct Look {
  const char* name;
  float yaw, pitch, field_of_view;  // degrees
};

/// Stands at a side of the crowd at the height of eyes, and looks across.
CameraPose close_to(const FramedBox& box, float height) {
  const glm::vec3 middle = 0.5F * (box.low + box.high);
  return {middle.x, box.low.y + 0.95F * height, box.high.z + 2.5F * height, 0.0F, -5.0F, 50.0F};
}

}  // namespace

FramedBox box_of(const Followers& followers, float height) {
  const GroundBounds& bounds = followers.bounds();
  const float beside = 0.3F * height;
  return {.low = {bounds.low.x - beside, 0.0F, bounds.low.y - beside},
          .high = {bounds.high.x + beside, height, bounds.high.y + beside}};
}

std::vector<NamedCamera> track_cameras(const Followers& followers, float height, float aspect,
                                       const PicturePart& part) {
  const FramedBox box = box_of(followers, height);
  // Cameras look from a long side, so that the crowd fills the width of the picture. A live crowd's is not known.
  const Trajectories& all = followers.trajectories();
  const bool is_known = !all.is_live || !all.plan.is_empty();
  const bool is_deep = is_known && box.high.z - box.low.z > box.high.x - box.low.x;
  const float turn = is_deep ? 90.0F : 0.0F;
  const std::array looks{Look{"front", turn + 20.0F, -28.0F, 42.0F},
                         Look{"above", turn, -64.0F, 50.0F},
                         Look{"close", 0.0F, 0.0F, 0.0F},
                         Look{"far", turn + 30.0F, -14.0F, 36.0F},
                         Look{"tower", turn + 12.0F, -42.0F, 45.0F},
                         Look{"top", 0.0F, -90.0F, plan_field_of_view}};
  std::vector<NamedCamera> cameras;
  for (const Look& look : looks) {
    if (look.field_of_view == 0.0F) {
      cameras.push_back({look.name, close_to(box, height)});
      continue;
    }
    render::Camera toward = camera_at({.yaw = look.yaw, .pitch = look.pitch, .field_of_view = look.field_of_view});
    render::Camera placed = framed(toward, {&box, 1}, aspect, part);
    if (placed.position.y > highest_camera) {  // a wider view sees it all from less high
      toward.vertical_view *= placed.position.y / highest_camera;
      placed = framed(toward, {&box, 1}, aspect, part);
    }
    cameras.push_back({look.name, place_of(placed)});
  }
  return cameras;
}

}  // namespace throng::app
