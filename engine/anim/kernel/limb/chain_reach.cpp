#include "engine/anim/kernel/limb/chain_reach.h"

#include <cassert>
#include <cstddef>

#include <glm/geometric.hpp>

#include "engine/anim/kernel/lanes/rotations.h"

namespace throng::anim {
namespace {

constexpr float shortest_chain = 1e-6F;         // metres
constexpr float straight_within = 1e-3F;        // of the chain's length: a joint no farther from a line is on it
constexpr float bend_of_straight = 0.02F;       // of a bone's length
constexpr glm::vec3 any_way{0.0F, 1.0F, 0.0F};  // of a vector without length

/// The joints from the first that turns to the end, model space.
class Solver {
 public:
  Solver(const ChainReachJob& job, const ChainMotion& motions) : job_(job) {
    const ReachChain& reach = *job.reach;
    count_ = static_cast<std::size_t>(reach.chain.count - reach.first);
    for (std::size_t i = 0; i < count_; ++i) {
      places_[i] = motions[static_cast<std::size_t>(reach.first) + i].position;
      if (i == 0) continue;
      lengths_[i - 1] = glm::distance(places_[i], places_[i - 1]);
      length_ += lengths_[i - 1];
    }
  }

  bool has_length() const { return length_ > shortest_chain; }
  const glm::vec3& place(std::size_t i) const { return places_[i]; }

  void solve() {
    const glm::vec3 root = places_[0];
    if (glm::distance(job_.target, root) >= length_) return stretch(root);
    bend_if_straight(root);
    for (int i = 0; i < job_.iterations && glm::distance(end(), job_.target) > job_.tolerance; ++i) {
      reach_back_from_target();
      reach_forward_from(root);
    }
  }

 private:
  const glm::vec3& end() const { return places_[count_ - 1]; }

  void stretch(const glm::vec3& root) {
    const glm::vec3 way = unit_or(job_.target - root, any_way);
    for (std::size_t i = 1; i < count_; ++i) places_[i] = places_[i - 1] + lengths_[i - 1] * way;
  }
  void reach_back_from_target() {
    places_[count_ - 1] = job_.target;
    for (std::size_t i = count_ - 1; i > 0; --i) place_at_length(i, i - 1, lengths_[i - 1]);
  }
  void reach_forward_from(const glm::vec3& root) {
    places_[0] = root;
    for (std::size_t i = 1; i < count_; ++i) place_at_length(i - 1, i, lengths_[i - 1]);
  }
  void place_at_length(std::size_t from, std::size_t moved, float length) {
    places_[moved] = places_[from] + length * unit_or(places_[moved] - places_[from], any_way);
  }

  /// A straight chain whose target lies on its line would only ever slide along that.
  void bend_if_straight(const glm::vec3& root) {
    const glm::vec3 line = unit_or(end() - root, any_way);
    const auto off_line = [&](const glm::vec3& place) { return glm::length(perpendicular_part(place - root, line)); };
    for (std::size_t i = 1; i < count_; ++i) {
      if (off_line(places_[i]) > straight_within * length_) return;
    }
    if (off_line(job_.target) > straight_within * length_) return;
    const glm::vec3 aside = any_perpendicular(line);
    for (std::size_t i = 1; i + 1 < count_; ++i) places_[i] += bend_of_straight * lengths_[i - 1] * aside;
  }

  const ChainReachJob& job_;
  std::size_t count_ = 0;
  float length_ = 0.0F;
  glm::vec3 places_[JointChain::max_joints];
  float lengths_[JointChain::max_joints];
};

/// Turns each joint so that the next one is in the direction that was solved.
void turn_joints(const ChainReachJob& job, const Solver& solver, ChainMotion& motions) {
  const ReachChain& reach = *job.reach;
  JointMotion solved_parent = reach.first == 0 ? JointMotion{} : motions[static_cast<std::size_t>(reach.first) - 1];
  for (int joint = reach.first; joint < reach.chain.tip(); ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    const auto i = static_cast<std::size_t>(joint - reach.first);
    const int bone = reach.chain.bones[j];
    const int next = reach.chain.bones[j + 1];
    const glm::quat before = job.pose.rotation(bone);
    const glm::quat followed = solved_parent.rotation * before;
    const glm::vec3 posed = unit_or(followed * (reach.chain.offsets[j + 1] + job.pose.position(next)), any_way);
    const glm::vec3 solved = unit_or(solver.place(i + 1) - solver.place(i), posed);
    const glm::quat turned = glm::normalize(shortest_turn(posed, solved) * followed);
    const glm::quat local = glm::normalize(glm::conjugate(solved_parent.rotation) * turned);
    job.pose.set_rotation(bone, job.weight >= 1.0F ? local : mix_rotations(before, local, job.weight));
    solved_parent.rotation = turned;
  }
  pose_chain(reach.chain, job.pose, motions, reach.first);
}

}  // namespace

Result<ReachChain> make_reach_chain(const Skeleton& skeleton, int first, int last) {
  Result<JointChain> chain = make_joint_chain(skeleton, last);
  if (!chain) return chain.error();
  const auto name = [&](int bone) {
    return bone < 0 || bone >= skeleton.bone_count() ? "number " + std::to_string(bone)
                                                     : "'" + skeleton.bones[static_cast<std::size_t>(bone)].name + "'";
  };
  const int place = chain->find(first);
  if (place < 0 || place == chain->tip()) {
    return Error{"bone " + name(last) + " of skeleton '" + skeleton.name + "' is not below bone " + name(first) +
                 ", so no chain leads from one to the other: name a bone above it"};
  }
  float length = 0.0F;
  for (int joint = place + 1; joint < chain->count; ++joint) {
    length += glm::length(chain->offsets[static_cast<std::size_t>(joint)]);
  }
  if (length <= shortest_chain) {
    return Error{"the bones from " + name(first) + " to " + name(last) + " of skeleton '" + skeleton.name +
                 "' are at one position, so they cannot reach: name bones that lie apart"};
  }
  return ReachChain{.chain = *chain, .first = place};
}

float reach_with_chain(const ChainReachJob& job) {
  assert(is_valid(job));
  if (!is_within(job.reach->chain, job.pose) || !is_place(job.target)) return 0.0F;
  ChainMotion motions;
  pose_chain(job.reach->chain, job.pose, motions);
  const auto tip = static_cast<std::size_t>(job.reach->chain.tip());
  Solver solver(job, motions);
  if (job.weight > 0.0F && solver.has_length()) {
    solver.solve();
    turn_joints(job, solver, motions);
  }
  return glm::distance(motions[tip].position, job.target);
}

}  // namespace throng::anim
