#pragma once

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/pose.h"
#include "engine/anim/base/transform.h"
#include "engine/anim/kernel/palette/hierarchy.h"

/// Small hand-made skeletons, poses of them, and the palettes that plain double-precision matrices give.
namespace throng::anim::kernel_rig {

/// Returns a trunk off which limbs branch, and digits off the limbs: chains, branches and returns to far ancestors.
std::vector<int> branching_parents(int bones);
std::vector<int> chain_parents(int bones);

/// Returns a skeleton whose rest transforms have random rotations, are 10 to 30 cm long, and have a uniform scale here
/// and there. Some bones have a rigid prefix. References are those of the rest pose.
Skeleton rigid_skeleton(const std::vector<int>& parents, unsigned seed = 1);

/// Returns the same with sheared and unevenly scaled prefixes, and 0 to 3 palette entries a bone with sheared posts.
Skeleton general_skeleton(const std::vector<int>& parents, unsigned seed = 1);

/// The local transforms of a pose, one a bone. General skeletons get animated scales, some of them negative.
using LocalPose = std::vector<StateTransform>;
LocalPose rest_pose(const Skeleton& skeleton);
LocalPose random_pose(const Skeleton& skeleton, unsigned seed);

/// The numbers that a state stores for a pose, by the formulas of skeleton.h in double: float [packet][component][16],
/// aligned.
struct alignas(64) PosePacket {
  float lanes[general_components * packet_bones];
};
class StatePose {
 public:
  StatePose(const Skeleton& skeleton, const LocalPose& pose);
  int components() const { return components_; }
  const float* packet(int index) const { return packets_[static_cast<std::size_t>(index)].lanes; }

 private:
  int components_;
  friend std::vector<StatePose> displaced_in(QuadMask quads, std::vector<StatePose> poses, float elsewhere);
  std::vector<PosePacket> packets_;
};

/// Returns the same poses with the positions outside `quads` in every packet replaced: by 0, where a bone is at rest,
/// or by anything.
std::vector<StatePose> displaced_in(QuadMask quads, std::vector<StatePose> poses, float elsewhere = 0.0F);
inline constexpr float not_there = std::numeric_limits<float>::quiet_NaN();

/// Returns the palette by 4x4 matrices in double, from the skeleton and its local transforms alone.
std::vector<glm::dmat4> reference_palette(const Skeleton& skeleton, const LocalPose& pose);

/// Returns the largest distance between what an entry and its reference make of points up to a metre from the bone's
/// origin.
double largest_error(const Skeleton& skeleton, const std::vector<glm::dmat4>& reference,
                     const std::vector<PaletteMatrix>& palette);

}  // namespace throng::anim::kernel_rig
