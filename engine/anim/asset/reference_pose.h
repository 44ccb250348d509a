#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// A pose straight from the definition, in double: what streams, kernels and error meters are measured against.
struct ReferencePose {
  std::vector<StateTransform> locals;  ///< one a bone, parent space, as the file defines them; rotations are unit
  std::vector<glm::dmat4> globals;     ///< one a bone, model space
  std::vector<glm::dmat4> palette;     ///< one a palette entry, model space
};

/// Value of a track at `seconds` (glTF 2.0 appendix C); the nearest key holds outside its keys. The track has keys.
glm::dvec3 sample_track(const Track<glm::vec3>& track, double seconds);
/// The same for rotations, unit. LINEAR is spherical, over the shorter arc, between normalised keys.
glm::dquat sample_track(const Track<glm::quat>& track, double seconds);

/// Local transform of a bone without a clip.
StateTransform rest_transform(const Bone& bone);

/// `tracks` may be null: the rest transform.
StateTransform sample_bone(const Bone& bone, const BoneTracks* tracks, double seconds);

/// `clip` may be null: the rest pose.
ReferencePose reference_pose(const Skeleton& skeleton, const Clip* clip, double seconds);

/// Globals and palette of any local pose, one transform a bone.
ReferencePose pose_from_locals(const Skeleton& skeleton, std::vector<StateTransform> locals);

/// translation * rotation * scale (glTF 2.0, 3.5.3).
glm::dmat4 compose(const StateTransform& local);

}  // namespace throng::anim
