#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/anim/rig/ragdoll_bones.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::anim {
namespace {

/// The roles of a limb's three bodies; the third may be missing.
struct LimbBodies {
  int side = 0;
  std::array<RagdollPart, 3> parts;
  std::array<BodyRole, 3> roles;
};
constexpr std::array arm_parts{RagdollPart::upper_arm, RagdollPart::forearm, RagdollPart::hand};
constexpr std::array leg_parts{RagdollPart::thigh, RagdollPart::shin, RagdollPart::foot};
constexpr std::array arms{
    LimbBodies{1, arm_parts, {BodyRole::left_upper_arm, BodyRole::left_lower_arm, BodyRole::left_hand}},
    LimbBodies{-1, arm_parts, {BodyRole::right_upper_arm, BodyRole::right_lower_arm, BodyRole::right_hand}}};
constexpr std::array legs{
    LimbBodies{1, leg_parts, {BodyRole::left_upper_leg, BodyRole::left_lower_leg, BodyRole::left_foot}},
    LimbBodies{-1, leg_parts, {BodyRole::right_upper_leg, BodyRole::right_lower_leg, BodyRole::right_foot}}};

class Humanoid {
 public:
  explicit Humanoid(const Skeleton& skeleton) : skeleton_(skeleton), rig_(find_rig(skeleton)) {}

  std::vector<RagdollBone> choose() {
    const int pelvis = carrier(legs);
    const int chest = carrier(arms);
    if (pelvis < 0 || chest < 0 || !is_below(skeleton_, chest, pelvis) || !is_upright()) return {};
    add(pelvis, -1, RagdollPart::pelvis, 0);
    const int top = add_trunk(pelvis, chest);
    for (std::size_t side = 0; side < arms.size(); ++side) {
      if (!add_limb(top, arms[side]) || !add_limb(0, legs[side])) return {};
    }
    if (!follows_the_skeleton()) return {};
    return std::move(chosen_);
  }

 private:
  int parent(int bone) const { return skeleton_.parent(bone); }
  glm::dvec3 place(BodyRole role) const { return skeleton_.references[static_cast<std::size_t>(rig_.at(role))].origin; }

  /// Returns the lowest bone above both limbs, or -1.
  int carrier(const std::array<LimbBodies, 2>& limbs) const {
    const int left = rig_.at(limbs[0].roles[0]), right = rig_.at(limbs[1].roles[0]);
    return left < 0 || right < 0 ? -1 : common_ancestor(skeleton_, parent(left), right);
  }

  /// Says whether the arms begin above the legs. An animal's front legs begin before its hind legs.
  bool is_upright() const {
    const glm::dvec3 trunk = place(BodyRole::left_upper_arm) + place(BodyRole::right_upper_arm) -
                             place(BodyRole::left_upper_leg) - place(BodyRole::right_upper_leg);
    return std::abs(trunk.y) > glm::length(glm::dvec2(trunk.x, trunk.z));
  }

  int add(int bone, int hangs_on, RagdollPart part, int side) {
    chosen_.push_back({.bone = bone, .parent = hangs_on, .part = part, .side = side});
    return static_cast<int>(chosen_.size()) - 1;
  }

  /// Adds the trunk above the pelvis, which is there already. Returns the entry that carries the arms.
  int add_trunk(int pelvis, int chest) {
    std::vector<int> between;
    for (int bone = chest; bone != pelvis; bone = parent(bone)) between.push_back(bone);
    int top = 0;
    if (between.size() > 1) top = add(between[(between.size() + 1) / 2], top, RagdollPart::spine, 0);
    if (!between.empty()) top = add(chest, top, RagdollPart::chest, 0);
    const int head = rig_.at(BodyRole::head);
    if (head >= 0 && is_below(skeleton_, head, chest)) add(head, top, RagdollPart::head, 0);
    return top;
  }

  /// Adds a limb. Returns false if one of the first two of its three parts is missing. The third may be missing, or lie
  /// elsewhere in the skeleton, because some rigs move feet by themselves.
  bool add_limb(int hangs_on, const LimbBodies& limb) {
    const int upper = rig_.at(limb.roles[0]), lower = rig_.at(limb.roles[1]), end = rig_.at(limb.roles[2]);
    if (upper < 0 || lower < 0 || !is_below(skeleton_, lower, upper)) return false;
    const int upper_entry = add(upper, hangs_on, limb.parts[0], limb.side);
    const int lower_entry = add(lower, upper_entry, limb.parts[1], limb.side);
    if (end >= 0) add(end, lower_entry, limb.parts[2], limb.side);
    return true;
  }

  /// Says whether no entry stands below a later one. Names alone could put a foot under the other thigh.
  bool follows_the_skeleton() const {
    for (std::size_t low = 0; low < chosen_.size(); ++low) {
      for (std::size_t high = low + 1; high < chosen_.size(); ++high) {
        if (is_below(skeleton_, chosen_[low].bone, chosen_[high].bone)) return false;
      }
    }
    return true;
  }

  const Skeleton& skeleton_;
  RigMap rig_;
  std::vector<RagdollBone> chosen_;
};

}  // namespace

std::vector<RagdollBone> choose_humanoid_bones(const Skeleton& skeleton) { return Humanoid(skeleton).choose(); }

}  // namespace throng::anim
