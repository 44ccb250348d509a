#include "engine/anim/rig/rig_map.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "engine/anim/rig/limb_names.h"

namespace throng::anim {

namespace {

/// The roles of one side, in the order of the limbs' bones.
struct SideRoles {
  BodySide side;
  BodyRole shoulder, upper_arm, lower_arm, hand, upper_leg, lower_leg, foot, toes;
};
constexpr SideRoles left_roles{BodySide::left,           BodyRole::left_shoulder, BodyRole::left_upper_arm,
                               BodyRole::left_lower_arm, BodyRole::left_hand,     BodyRole::left_upper_leg,
                               BodyRole::left_lower_leg, BodyRole::left_foot,     BodyRole::left_toes};
constexpr SideRoles right_roles{BodySide::right,           BodyRole::right_shoulder, BodyRole::right_upper_arm,
                                BodyRole::right_lower_arm, BodyRole::right_hand,     BodyRole::right_upper_leg,
                                BodyRole::right_lower_leg, BodyRole::right_foot,     BodyRole::right_toes};

class RigFinder {
 public:
  explicit RigFinder(const Skeleton& skeleton) : skeleton_(skeleton), names_(limb_names(skeleton)) {
    map_.bones.fill(-1);
    map_.limbs = find_limbs(skeleton);
  }

  RigMap find() {
    take_said();
    take_limbs(left_roles, map_.limbs.left_arm, map_.limbs.left_leg);
    take_limbs(right_roles, map_.limbs.right_arm, map_.limbs.right_leg);
    take_trunk();
    take_shoulder(left_roles);
    take_shoulder(right_roles);
    return std::move(map_);
  }

 private:
  int parent(int bone) const { return skeleton_.parent(bone); }

  void take(BodyRole role, int bone) {
    const bool is_new = bone >= 0 && map_.at(role) < 0 && std::ranges::count(map_.bones, bone) == 0;
    if (is_new) map_.bones[index_of(role)] = bone;
  }

  void take_said() {
    for (int bone = 0; bone < skeleton_.bone_count(); ++bone) {
      const std::optional<BodyRole> role = skeleton_.bones[static_cast<std::size_t>(bone)].role;
      if (role) take(*role, bone);
    }
  }

  /// Returns the first bone with one of these names; the parents among them come first.
  int first_called(BodySide side, std::initializer_list<BodyPart> parts) const {
    for (const BodyPart part : parts) {
      const auto found = std::ranges::find(names_, LimbName{part, side});
      if (found != names_.end()) return static_cast<int>(found - names_.begin());
    }
    return -1;
  }

  LimbBones arm_by_name(BodySide side) const {
    return ordered({.upper = first_called(side, {BodyPart::upper_arm, BodyPart::arm}),
                    .middle = first_called(side, {BodyPart::lower_arm}),
                    .end = first_called(side, {BodyPart::hand})});
  }

  LimbBones leg_by_name(BodySide side) const {
    return ordered({.upper = first_called(side, {BodyPart::upper_leg}),
                    .middle = first_called(side, {BodyPart::lower_leg, BodyPart::leg}),
                    .end = first_called(side, {BodyPart::foot})});
  }

  /// Returns the limb, or none of its bones where the lower half is not below the upper.
  LimbBones ordered(const LimbBones& limb) const {
    const bool fits = limb.upper >= 0 && limb.middle > limb.upper && is_below(skeleton_, limb.middle, limb.upper);
    return fits ? limb : LimbBones{};
  }

  void take_limbs(const SideRoles& roles, const std::optional<LimbBones>& arm, const std::optional<LimbBones>& leg) {
    const LimbBones upper = arm ? *arm : arm_by_name(roles.side);
    take(roles.upper_arm, upper.upper);
    take(roles.lower_arm, upper.middle);
    take(roles.hand, upper.end);
    const LimbBones lower = leg ? *leg : leg_by_name(roles.side);
    take(roles.upper_leg, lower.upper);
    take(roles.lower_leg, lower.middle);
    take(roles.foot, lower.end);
    take(roles.toes, lower.tip);
  }

  /// Returns the lowest bone above both, or -1.
  int carrier(BodyRole left, BodyRole right) const {
    const bool has_both = map_.at(left) >= 0 && map_.at(right) >= 0;
    return has_both ? common_ancestor(skeleton_, parent(map_.at(left)), map_.at(right)) : -1;
  }

  int hips() const {
    const int carries = carrier(BodyRole::left_upper_leg, BodyRole::right_upper_leg);
    return carries >= 0 ? carries : map_.limbs.pelvis.value_or(-1);
  }

  void take_trunk() {
    take(BodyRole::hips, hips());
    take(BodyRole::head, map_.limbs.head.value_or(first_called(BodySide::none, {BodyPart::head})));
    const int hips = map_.at(BodyRole::hips);
    const int chest = carrier(BodyRole::left_upper_arm, BodyRole::right_upper_arm);
    if (hips < 0 || chest <= hips || !is_below(skeleton_, chest, hips)) return;
    take(BodyRole::chest, chest);
    int spine = chest;
    while (parent(spine) != hips) spine = parent(spine);
    take(BodyRole::spine, spine);
    int neck = map_.at(BodyRole::head);
    if (neck <= chest || !is_below(skeleton_, neck, chest)) return;
    while (parent(neck) != chest) neck = parent(neck);
    take(BodyRole::neck, neck);
  }

  /// The collar bone is the first bone of an arm's way from the chest.
  void take_shoulder(const SideRoles& roles) {
    const int chest = map_.at(BodyRole::chest);
    int bone = map_.at(roles.upper_arm);
    if (chest < 0 || bone <= chest || !is_below(skeleton_, bone, chest)) return;
    while (parent(bone) != chest) bone = parent(bone);
    take(roles.shoulder, bone);
  }

  const Skeleton& skeleton_;
  std::vector<LimbName> names_;
  RigMap map_;
};

}  // namespace

RigMap find_rig(const Skeleton& skeleton) { return RigFinder(skeleton).find(); }

}  // namespace throng::anim
