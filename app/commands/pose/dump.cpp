#include "app/commands/pose/dump.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/anim/asset/reference_pose.h"

namespace throng::app {

namespace {

Json json_of(const glm::dmat4& matrix) {
  Json numbers = Json::array();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) numbers.push_back(matrix[column][row]);
  }
  return numbers;
}

Json json_of(const glm::dvec3& vector) { return Json::array({vector.x, vector.y, vector.z}); }

Json json_of(const glm::dquat& rotation) { return Json::array({rotation.x, rotation.y, rotation.z, rotation.w}); }

/// Globals of all bones. Rigid: the palette's matrices, put back on the bind pose. General: composed from the local
/// transforms, because an inverse bind matrix need not be invertible.
std::vector<glm::dmat4> find_globals(const anim::Skeleton& skeleton, const BonePose& pose,
                                     const std::vector<anim::StateTransform>& locals) {
  if (!skeleton.rigid) return anim::pose_from_locals(skeleton, locals).globals;
  std::vector<glm::dmat4> globals;
  for (std::size_t bone = 0; bone < pose.palette.size(); ++bone) {
    const anim::ReferenceFrame& frame = skeleton.references[bone];
    globals.push_back(
        pose.palette[bone] *
        anim::compose({.rotation = frame.rotation, .position = frame.origin, .scale = glm::dvec3(frame.scale)}));
  }
  return globals;
}

constexpr float unit_within = 5e-5F;

bool has_unit_keys(const anim::Clip* clip, int bone) {
  if (clip == nullptr) return true;
  const auto tracks = std::ranges::find(clip->tracks, bone, &anim::BoneTracks::bone);
  if (tracks == clip->tracks.end() || tracks->rotation.interpolation == anim::Interpolation::cubic_spline) return true;
  return std::ranges::all_of(tracks->rotation.values,
                             [](const glm::quat& key) { return std::abs(glm::length(key) - 1.0F) <= unit_within; });
}

}  // namespace

Json describe_skin(const anim::Model& model, const anim::Skin& skin) {
  Json joints = Json::array();
  Json names = Json::array();
  for (const int bone : skin.bones) {
    joints.push_back(model.skeleton.bones[static_cast<std::size_t>(bone)].node);
    names.push_back(model.skeleton.bones[static_cast<std::size_t>(bone)].name);
  }
  return {{"jointNames", std::move(names)},
          {"joints", std::move(joints)},
          {"meshNodes", skin.mesh_nodes},
          {"name", skin.name},
          {"skin", skin.skin}};
}

Json dump_skin(const anim::Model& model, const anim::Skin& skin, const anim::Clip* clip, const BonePose& pose) {
  const anim::Skeleton& skeleton = model.skeleton;
  std::vector<anim::StateTransform> locals;
  locals.reserve(skeleton.bones.size());
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    locals.push_back(anim::to_local(skeleton, bone, pose.states[static_cast<std::size_t>(bone)]));
  }
  const std::vector<glm::dmat4> globals = find_globals(skeleton, pose, locals);

  Json joints = Json::array();
  Json palette = Json::array();
  for (std::size_t joint = 0; joint < skin.bones.size(); ++joint) {
    const auto bone = static_cast<std::size_t>(skin.bones[joint]);
    Json dumped = {{"global", json_of(globals[bone])}, {"node", skeleton.bones[bone].node}};
    if (!skeleton.bones[bone].prefix_holds_matrix) {
      if (has_unit_keys(clip, skin.bones[joint])) dumped["r"] = json_of(locals[bone].rotation);
      dumped["s"] = json_of(locals[bone].scale);
      dumped["t"] = json_of(locals[bone].position);
    }
    joints.push_back(std::move(dumped));
    const auto entry = static_cast<std::size_t>(skin.palette_entries[joint]);
    palette.push_back(json_of(pose.palette[entry] * skin.bind_to_model));
  }
  return {{"joints", std::move(joints)}, {"scenePalette", std::move(palette)}, {"skin", skin.skin}};
}

}  // namespace throng::app
