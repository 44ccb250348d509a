#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// A pose straight from the definition, in double. Streams, kernels and error meters are measured against it.
struct ReferencePose {
  std::vector<StateTransform> locals;  ///< one a bone, parent space, as the file defines them; rotations are unit
  std::vector<glm::dmat4> globals;     ///< one a bone, model space
  std::vector<glm::dmat4> palette;     ///< one a palette entry, model space
};

/// Returns the value of a track at `seconds` (glTF 2.0, appendix C). Before the first key and after the last, the
/// nearest key holds. The track has keys.
glm::dvec3 sample_track(const Track<glm::vec3>& track, double seconds);
/// Returns a unit rotation in the same way. LINEAR is spherical, over the shorter arc, between normalised keys.
glm::dquat sample_track(const Track<glm::quat>& track, double seconds);

/// Returns the local transform of a bone without a clip.
StateTransform rest_transform(const Bone& bone);

/// Returns the local transform of a bone; `tracks` may be null, for the rest transform.
StateTransform sample_bone(const Bone& bone, const BoneTracks* tracks, double seconds);

/// Poses a skeleton; `clip` may be null, for the rest pose.
ReferencePose reference_pose(const Skeleton& skeleton, const Clip* clip, double seconds);

/// Computes globals and palette of a local pose, one transform a bone.
ReferencePose pose_from_locals(const Skeleton& skeleton, std::vector<StateTransform> locals);

/// Returns translation * rotation * scale (glTF 2.0, 3.5.3).
glm::dmat4 compose(const StateTransform& local);

/// Returns the state in which every bone stands to its parent as in the bind pose, so that its skin follows the parent.
/// A level of detail without the bone shows this. The layout is float [packet][components][16]. On rigid skeletons it
/// is the identity; on others it comes from the inverse bind matrices (without shear), or from the rest transform where
/// a bone has none.
std::vector<float> still_pose(const Skeleton& skeleton);

}  // namespace throng::anim
