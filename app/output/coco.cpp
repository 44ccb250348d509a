#include "app/output/coco.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "engine/anim/asset/joint_list.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::app {
namespace {

using anim::BodyRole;

/// The joints from left_shoulder on, in the order of COCO.
constexpr std::array coco_roles{BodyRole::left_upper_arm,  BodyRole::right_upper_arm, BodyRole::left_lower_arm,
                                BodyRole::right_lower_arm, BodyRole::left_hand,       BodyRole::right_hand,
                                BodyRole::left_upper_leg,  BodyRole::right_upper_leg, BodyRole::left_lower_leg,
                                BodyRole::right_lower_leg, BodyRole::left_foot,       BodyRole::right_foot};

/// The places of the face from the tip of the nose: to the left, up, ahead, in heights of a head. The right side
/// mirrors the left.
constexpr glm::vec3 left_eye_from_nose{0.14F, 0.13F, -0.12F}, left_ear_from_nose{0.32F, 0.06F, -0.45F};

/// The directions of a body in the bind pose.
struct BodyAxes {
  glm::vec3 left, up, ahead;
};

/// Returns the points of the surface that the head's bones carry, in model space.
std::vector<glm::vec3> points_of_head(const anim::Model& model, int head) {
  const std::vector<anim::Bone>& bones = model.skeleton.bones;
  std::vector<bool> is_head(bones.size());
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    const int parent = bones[bone].parent;
    is_head[bone] = static_cast<int>(bone) == head || (parent >= 0 && is_head[static_cast<std::size_t>(parent)]);
  }
  std::vector<glm::vec3> points;
  for (const anim::SkinnedMesh& mesh : model.meshes) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      if (is_head[mesh.palette_entries[i][0]]) points.push_back(mesh.positions[i]);  // an entry a bone: it is rigid
    }
  }
  return points;
}

/// Where the face is on a head.
struct Face {
  glm::vec3 nose;
  float head_height;
};

std::optional<Face> find_face(std::span<const glm::vec3> points, const glm::vec3& joint, const BodyAxes& axes) {
  if (points.empty()) return {};
  const auto by_height = [&](const glm::vec3& a, const glm::vec3& b) { return dot(a, axes.up) < dot(b, axes.up); };
  const auto [lowest, highest] = std::ranges::minmax(points, by_height);
  const float bottom = dot(lowest, axes.up), height = dot(highest, axes.up) - bottom;
  constexpr float middle_width = 0.1F, brow = 0.7F;  // heights of a head: hair and hats may reach further ahead
  std::optional<glm::vec3> nose;
  for (const glm::vec3& point : points) {
    if (std::abs(dot(point - joint, axes.left)) > middle_width * height) continue;
    if (dot(point, axes.up) > bottom + brow * height) continue;
    if (!nose || dot(point, axes.ahead) > dot(*nose, axes.ahead)) nose = point;
  }
  if (!nose || height <= 0.0F) return {};
  return Face{*nose, height};
}

void find_face_points(const CharacterSource& source, const anim::RigMap& rig, CocoPoints& points) {
  const anim::Skeleton& skeleton = source.model.skeleton;
  const int head = rig.at(BodyRole::head);
  if (head < 0 || !skeleton.rigid) return;
  const glm::mat4 bind(anim::bind_global(skeleton, head));
  const glm::vec3 up(0.0F, 1.0F, 0.0F), ahead = rig.limbs.forward;
  const BodyAxes axes{glm::cross(up, ahead), up, ahead};
  const auto face = find_face(points_of_head(source.model, head), glm::vec3(bind[3]), axes);
  if (!face) return;
  const glm::mat4 to_head = glm::inverse(bind);
  const auto put = [&](std::size_t point, const glm::vec3& from_nose) {
    const glm::vec3 place =
        face->nose + face->head_height * (from_nose.x * axes.left + from_nose.y * axes.up + from_nose.z * axes.ahead);
    points.at(point) = {head, glm::vec3(to_head * glm::vec4(place, 1.0F))};
  };
  const glm::vec3 mirrored(-1.0F, 1.0F, 1.0F);
  put(0, glm::vec3(0.0F));
  put(1, left_eye_from_nose);
  put(2, mirrored * left_eye_from_nose);
  put(3, left_ear_from_nose);
  put(4, mirrored * left_ear_from_nose);
}

}  // namespace

CocoPoints coco_points(const CharacterSource& source) {
  CocoPoints points;
  if (source.roles.is_prop) return points;
  const anim::RigMap rig = anim::find_rig(source.model.skeleton);
  for (std::size_t i = 0; i < coco_roles.size(); ++i) points.at(coco_face_points + i).bone = rig.at(coco_roles.at(i));
  find_face_points(source, rig, points);
  return points;
}

}  // namespace throng::app
