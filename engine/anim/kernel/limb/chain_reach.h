#pragma once

#include <type_traits>

#include "engine/anim/kernel/limb/joint_chain.h"

namespace throng::anim {

/// Bones that reach together, such as a tail, a tentacle or a spine. They are made at load and shared by every
/// character of the skeleton.
struct ReachChain {
  JointChain chain;  ///< its tip is the end that reaches
  int first = 0;     ///< index into the chain of the first joint that turns; it stays where it is
};
static_assert(std::is_trivially_copyable_v<ReachChain>);

/// Makes a chain of the bones from `first` down to `last`. Errors: those of make_joint_chain; `last` is not below
/// `first`; all of them are at one position.
Result<ReachChain> make_reach_chain(const Skeleton& skeleton, int first, int last);

inline constexpr int most_reach_iterations = 64;

/// Brings the end of a chain to a target by forward and backward reaching (A. Aristidou and J. Lasenby, "FABRIK: A
/// fast, iterative solver for the Inverse Kinematics problem", Graphical Models 73, 2011). It starts from the pose, so
/// it keeps no state. Bones keep their lengths and turn by the shortest way, without twist of their own. A chain
/// stretches out straight towards a target out of reach. The end keeps its rotation from the bone that carries it.
///
/// The pose stays as it is where this level of detail lacks the chain, and where the target is not finite (see
/// is_place).
struct ChainReachJob {
  const ReachChain* reach = nullptr;
  PoseView pose;
  glm::vec3 target{0.0F};   ///< model space, metres
  float weight = 1.0F;      ///< 0 leaves the pose to the bit, 1 reaches
  int iterations = 16;      ///< 1 to most_reach_iterations: no more of them are made,
  float tolerance = 1e-3F;  ///< metres: nor any once the end is as near to the target
};
bool is_valid(const ChainReachJob& job);

/// Returns the metres from the end to the target now; 0 where the pose stays as it is for the reasons above.
float reach_with_chain(const ChainReachJob& job);

}  // namespace throng::anim
