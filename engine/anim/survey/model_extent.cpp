#include "engine/anim/survey/model_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/box.h"
#include "engine/anim/rig/limbs.h"
#include "engine/anim/survey/surface_points.h"

namespace throng::anim {

namespace {

constexpr std::size_t most_places = 2000;
constexpr int measured_poses = 6;
constexpr double alike_heights = 2.0;  // a rest pose of at most so many times the clips' height says the size
constexpr double same_ground = 0.1;    // of the height: the rest pose stands where the clips do
constexpr double no_side = 1e-9;       // units: a model that is smaller has no extent

/// Holds the measurements of one clip, or of the rest pose.
struct Room {
  glm::dvec3 size{0.0};  ///< of its poses, on average
  glm::dvec3 middle{0.0};
  double lowest = 0.0;  ///< of standing points: the median over poses, for a toe may dip below the ground for a moment
  double top = -std::numeric_limits<double>::infinity();
};

/// Returns the median; of two in the middle the lower one, or the upper one.
double middle_of(std::vector<double> values, bool upper = false) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - (upper ? 0 : 1)) / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Says of each bone whether a character stands on it: on its legs where both are known, for a sword may hang lower.
std::vector<bool> bones_to_stand_on(const Skeleton& skeleton) {
  const Limbs limbs = find_limbs(skeleton);
  std::vector<bool> stands(skeleton.bones.size(), !limbs.left_leg || !limbs.right_leg);
  if (stands.empty() || stands.front()) return stands;
  for (const LimbBones* leg : {&*limbs.left_leg, &*limbs.right_leg}) {
    for (const int bone : {leg->upper, leg->end}) stands[static_cast<std::size_t>(bone)] = true;
  }
  for (std::size_t bone = 0; bone < stands.size(); ++bone) {
    const int parent = skeleton.bones[bone].parent;
    if (parent >= 0 && stands[static_cast<std::size_t>(parent)]) stands[bone] = true;
  }
  return stands;
}

class ExtentSurvey {
 public:
  ExtentSurvey(const Model& model, const glm::dquat& upright)
      : model_(model), upright_(upright), points_(sample_surface(model, most_places)) {
    const std::vector<bool> bones = bones_to_stand_on(model.skeleton);
    for (std::size_t point = 0; point < points_.count(); ++point) {
      const auto influences = points_.of(point);
      stands_.push_back(!influences.empty() && bones[static_cast<std::size_t>(main_bone(model.skeleton, influences))]);
    }
    if (std::ranges::count(stands_, true) == 0) stands_.assign(points_.count(), true);
  }

  std::optional<ModelExtent> measure() const {
    const std::optional<Room> rest = room_of(nullptr, 1);
    std::vector<Room> rooms;
    for (const Clip& clip : model_.clips) {
      if (const auto room = room_of(&clip, measured_poses)) rooms.push_back(*room);
    }
    if (rooms.empty() && rest) rooms.push_back(*rest);
    if (rooms.empty()) return std::nullopt;
    ModelExtent extent = median_of(rooms);
    extent.top = extent.lowest + extent.size.y;
    if (rest && are_alike(rest->size.y, extent.size.y)) {
      extent.size = rest->size;
      const bool stands_there = std::abs(rest->lowest - extent.lowest) < same_ground * extent.size.y;
      extent.top = stands_there ? rest->top : extent.lowest + extent.size.y;
    }
    if (!(std::max({extent.size.x, extent.size.y, extent.size.z}) > no_side)) return std::nullopt;
    return extent;
  }

 private:
  std::optional<Room> room_of(const Clip* clip, int samples) const {
    Room room;
    std::vector<double> lowest;
    for (int i = 0; i < samples; ++i) {
      const double seconds = clip == nullptr ? 0.0 : clip->start + (clip->duration - clip->start) * i / samples;
      Box box, standing;
      const std::vector<glm::dvec3> at = places(points_, reference_pose(model_.skeleton, clip, seconds));
      for (std::size_t point = 0; point < at.size(); ++point) {
        const glm::dvec3 place = upright_ * at[point];
        if (!std::isfinite(place.x + place.y + place.z)) continue;
        box.add(place);
        if (stands_[point]) standing.add(place);
      }
      if (box.is_empty()) continue;
      if (lowest.empty()) room.middle = box.middle();
      room.size += box.size();
      lowest.push_back(standing.low.y);
      room.top = std::max(room.top, box.high.y);
    }
    if (lowest.empty()) return std::nullopt;
    room.size /= static_cast<double>(lowest.size());
    room.lowest = middle_of(lowest);
    return room;
  }

  static bool are_alike(double a, double b) { return a <= alike_heights * b && b <= alike_heights * a; }

  template <typename Value>
  static std::vector<double> values_of(const std::vector<Room>& rooms, const Value& value) {
    std::vector<double> values;
    values.reserve(rooms.size());
    for (const Room& room : rooms) values.push_back(value(room));
    return values;
  }

  static ModelExtent median_of(const std::vector<Room>& rooms) {
    ModelExtent extent;
    for (int axis = 0; axis < 3; ++axis) {
      extent.size[axis] = middle_of(values_of(rooms, [axis](const Room& room) { return room.size[axis]; }));
      extent.middle[axis] = middle_of(values_of(rooms, [axis](const Room& room) { return room.middle[axis]; }));
    }
    // Of a walk and a handstand that reaches below the ground, the walk says where it is.
    extent.lowest = middle_of(values_of(rooms, [](const Room& room) { return room.lowest; }), true);
    return extent;
  }

  const Model& model_;
  glm::dquat upright_;
  SurfacePoints points_;
  std::vector<bool> stands_;  // [point] the character stands on it
};

}  // namespace

std::optional<ModelExtent> measure_extent(const Model& model, const glm::dquat& upright) {
  return ExtentSurvey(model, upright).measure();
}

}  // namespace throng::anim
