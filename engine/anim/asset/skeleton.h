#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "throng/lod_rules.h"

#include "engine/anim/asset/body_role.h"
#include "engine/anim/base/transform.h"

namespace throng::anim {

struct Bone {
  std::string name;
  int node = -1;                      ///< index of the glTF node it came from
  int parent = -1;                    ///< index of its parent bone, always below its own; -1 for a root
  Transform rest;                     ///< local transform of the file; identity where `prefix` holds the node's matrix
  glm::dmat4 prefix{1.0};             ///< what never moves between parent and bone: static nodes that are no
                                      ///< bones, or a matrix that is not a plain TRS. local = prefix * T * R * S
  bool prefix_holds_matrix = false;   ///< `prefix` has the node's own matrix, which no T, R and S can say
  std::optional<BodyRole> role = {};  ///< as the file or a person says it; else the name may say it (rig/limb_names.h)
};

/// The place of a bone in the bind pose, in model space, without scale. Animation states are relative to it.
/// A state stores, for each bone b with parent p (p = identity for a root):
///     rotation  q' = p.rotation * (prefix rotation * q) * inverse(b.rotation)
///     position  d  = p.origin + p.rotation * (p.scale * (prefix * t)) - b.origin
/// The bind pose is then the identity, and interpolation, blending and additive layers commute with the conversion.
struct ReferenceFrame {
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 origin{0.0};
  double scale = 1.0;  ///< constant uniform scale of the bone's global transform
};

/// A matrix that the kernels write for a bone: bone global * post.
struct PaletteEntry {
  int bone = 0;
  glm::dmat4 post{1.0};  ///< inverse bind matrix
};

/// A hierarchy of bones, and the way from local transforms to a palette.
///
/// Bones are ordered level by level, parents before children, depth-first inside a level. Every level of detail is
/// therefore a prefix of the transforms, of the sampled rows and of the palette.
///
/// rigid:  every bind and every animated local transform is rigid up to one uniform scale a bone. References are set.
///         The palette has exactly one matrix a bone, in bone order: palette = model-space motion from the bind pose.
///         (Import brings the vertices of SkinnedMesh to that space.)
/// else:   references are the identity, and states hold plain local rotation, translation and scale. The palette has
///         `palette` entries, sorted by bone, each bone global * post.
struct Skeleton {
  std::string name;
  bool rigid = true;
  std::vector<Bone> bones;                 ///< 1 to max_bones
  std::vector<ReferenceFrame> references;  ///< one a bone
  std::vector<PaletteEntry> palette;       ///< general path: any number, sorted by bone; rigid: one a bone, post unused
  std::vector<int> level_bone_counts;      ///< 1 to max_bone_levels prefixes, descending; [0] == bones.size()

  int bone_count() const { return static_cast<int>(bones.size()); }
  int parent(int bone) const { return bones[static_cast<std::size_t>(bone)].parent; }
  int palette_count() const { return static_cast<int>(palette.size()); }
  /// Returns the floats of a bone in a state: 4 of rotation, 3 of position, and 3 of scale on the general path.
  int components() const { return rigid ? 7 : 10; }
};

inline constexpr int max_bones = 1024;

/// Counts the palette entries that a level needs: entries whose bone is below `bone_count`.
int palette_count_for_bones(const Skeleton& skeleton, int bone_count);

/// Returns the bone itself, or its nearest ancestor below `bone_count`, which a dropped bone follows.
int nearest_kept_bone(const Skeleton& skeleton, int bone, int bone_count);

/// Returns true if `bone` is `ancestor` or lies below it.
bool is_below(const Skeleton& skeleton, int bone, int ancestor);

/// Returns the lowest bone that `a` and `b` are or lie below; -1 where there is none.
int common_ancestor(const Skeleton& skeleton, int a, int b);

/// The place of a joint in the space of its first palette entry: palette[entry] carries `position` to the posed joint.
/// `entry` is -1 for a bone that no skin uses.
struct JointPlace {
  int entry = -1;
  glm::dvec3 position{0.0};
};
JointPlace joint_place(const Skeleton& skeleton, int bone);

/// A bone's transform in double. to_state converts a local transform to a state (see ReferenceFrame), to_local back.
struct StateTransform {
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 position{0.0};
  glm::dvec3 scale{1.0};
};
/// store_state writes a state into a pose: float [packet][components][16].
StateTransform to_state(const Skeleton& skeleton, int bone, const StateTransform& local);
StateTransform to_local(const Skeleton& skeleton, int bone, const StateTransform& state);
void store_state(const StateTransform& state, int bone, int components, float* pose);

}  // namespace throng::anim
