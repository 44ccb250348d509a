#include "engine/anim/rig/limbs.h"

#include <algorithm>
#include <cstddef>

#include <glm/geometric.hpp>

#include "engine/anim/rig/limb_names.h"
#include "engine/anim/rig/limb_shapes.h"

namespace throng::anim {

namespace {

constexpr glm::vec3 up{0.0F, 1.0F, 0.0F};

/// The words for one kind of limb.
struct LimbWords {
  const char* limb;
  BodyPart upper;
  BodyPart either;
  BodyPart lower;
  BodyPart end;
  BodyPart base;  ///< begins the limb if no bone is called its upper half: "LeftShoulder", "LeftElbow"
};
constexpr LimbWords leg_words{"leg",          BodyPart::upper_leg, BodyPart::leg, BodyPart::lower_leg,
                              BodyPart::foot, BodyPart::upper_leg};
constexpr LimbWords arm_words{"arm",          BodyPart::upper_arm, BodyPart::arm, BodyPart::lower_arm,
                              BodyPart::hand, BodyPart::shoulder};

class LimbFinder {
 public:
  explicit LimbFinder(const Skeleton& skeleton)
      : skeleton_(skeleton), joints_(skeleton), names_(limb_names(skeleton)) {}

  Limbs find() {
    find_legs();
    find_arms();
    find_trunk();
    return std::move(limbs_);
  }

 private:
  const LimbName& name(int bone) const { return names_[static_cast<std::size_t>(bone)]; }
  int parent(int bone) const { return skeleton_.parent(bone); }
  int bone_count() const { return skeleton_.bone_count(); }

  void doubt(const std::string& why) { limbs_.doubts.push_back("skeleton '" + skeleton_.name + "': " + why); }

  static std::string said(const LimbWords& words, BodySide side) {
    return std::string(side == BodySide::left ? "left " : "right ") + words.limb;
  }

  /// Returns the bones of a limb above its end, from below.
  std::vector<int> limb_above(const LimbWords& words, int end) const {
    std::vector<int> bones;
    for (int bone = parent(end); bone >= 0; bone = parent(bone)) {
      const LimbName& it = name(bone);
      if (it.part == BodyPart::helper) continue;
      const bool of_limb =
          it.part == words.upper || it.part == words.either || it.part == words.lower || it.part == words.base;
      if (!of_limb || it.side != name(end).side) break;
      bones.push_back(bone);
    }
    return bones;
  }

  /// Returns the topmost of these bones whose name says `part`, or -1.
  int topmost(const std::vector<int>& from_below, BodyPart part) const {
    const auto found =
        std::find_if(from_below.rbegin(), from_below.rend(), [&](int b) { return name(b).part == part; });
    return found == from_below.rend() ? -1 : *found;
  }

  /// Takes upper and middle from bones of a limb, listed from below; -1 where their names do not say them.
  LimbBones halves_among(const LimbWords& words, const std::vector<int>& from_below) const {
    LimbBones limb;
    limb.upper = topmost(from_below, words.upper);
    limb.middle = topmost(from_below, words.lower);
    const int either = topmost(from_below, words.either);
    if (limb.upper < 0 && limb.middle >= 0) limb.upper = either >= 0 ? either : topmost(from_below, words.base);
    if (limb.middle < 0 && limb.upper >= 0) limb.middle = either;
    const bool halves_alike = limb.upper < 0 && limb.middle < 0 && from_below.size() == 2 &&
                              name(from_below[0]).part == words.either && name(from_below[1]).part == words.either;
    if (halves_alike) {
      limb.upper = from_below[1];
      limb.middle = from_below[0];
    }
    return limb;
  }

  static bool has_halves(const LimbBones& limb) { return limb.upper >= 0 && limb.middle > limb.upper; }

  std::vector<int> bones_called(BodyPart part, BodySide side) const {
    std::vector<int> bones;
    for (int bone = 0; bone < bone_count(); ++bone) {
      if (name(bone) == LimbName{part, side}) bones.push_back(bone);
    }
    return bones;
  }

  std::ptrdiff_t bones_below(int bone) const {
    std::ptrdiff_t count = 0;
    for (int b = bone + 1; b < bone_count(); ++b) count += is_below(skeleton_, b, bone) ? 1 : 0;
    return count;
  }

  /// Keeps the end that carries most, where several bones could end one limb, as the palms of a hand do.
  void drop_lesser_ends(std::vector<LimbBones>& found) const {
    const auto of_one_limb = [&](const LimbBones& limb) {
      return limb.upper == found.front().upper && limb.middle == found.front().middle;
    };
    if (found.size() < 2 || !std::ranges::all_of(found, of_one_limb)) return;
    const auto carried = [&](const LimbBones& limb) { return bones_below(limb.end); };
    std::ranges::stable_sort(found, std::ranges::greater{}, carried);
    if (carried(found[0]) > carried(found[1])) found.resize(1);
  }

  /// Finds a limb whose end is not below its halves: each must be the only bone that its name says.
  std::optional<LimbBones> with_end_apart(const LimbWords& words, BodySide side, int end) const {
    std::vector<int> lower = bones_called(words.lower, side);
    if (lower.empty()) lower = bones_called(words.either, side);
    if (lower.empty()) return std::nullopt;
    std::vector<int> from_below{lower.back()};
    const std::vector<int> above = limb_above(words, lower.back());
    from_below.insert(from_below.end(), above.begin(), above.end());
    LimbBones limb = halves_among(words, from_below);
    limb.end = end;
    limb.end_stands_apart = true;
    return has_halves(limb) ? std::optional(limb) : std::nullopt;
  }

  std::optional<LimbBones> find_named(const LimbWords& words, BodySide side) {
    const std::vector<int> ends = bones_called(words.end, side);
    std::vector<LimbBones> found;
    for (const int end : ends) {
      LimbBones limb = halves_among(words, limb_above(words, end));
      limb.end = end;
      if (has_halves(limb)) found.push_back(limb);
    }
    drop_lesser_ends(found);
    if (found.size() == 1) return found.front();
    if (found.size() > 1) doubt("two bones could end the " + said(words, side) + ", so it is left out");
    if (!found.empty() || ends.empty()) return std::nullopt;
    std::optional<LimbBones> apart = ends.size() == 1 ? with_end_apart(words, side, ends.front()) : std::nullopt;
    if (!apart) doubt("the bone that is called the end of the " + said(words, side) + " is not below its two halves");
    return apart;
  }

  /// Returns the ball of the foot: the first bone below the ankle whose name says a toe or a further part of the foot.
  int toe_of(int ankle) const {
    for (int bone = ankle + 1; bone < bone_count(); ++bone) {
      const bool is_toe = name(bone).part == BodyPart::toe || name(bone).part == BodyPart::foot;
      if (is_toe && is_below(skeleton_, bone, ankle)) return bone;
    }
    return -1;
  }

  void find_legs() {
    std::optional<LimbBones> left = find_named(leg_words, BodySide::left);
    std::optional<LimbBones> right = find_named(leg_words, BodySide::right);
    if (left && right) {
      left->tip = toe_of(left->end);
      right->tip = toe_of(right->end);
      limbs_.named = true;
      keep_legs_if_on_their_sides(*left, *right);
    } else if (left || right) {
      doubt("only one leg was found, so which way the body faces is not known and no leg is used");
    } else if (const std::optional<LimbPair> legs = find_leg_shapes(joints_)) {
      keep_legs_by_shape(*legs);
    } else {
      doubt("no pair of legs was found by name or by shape");
    }
  }

  void keep_legs_if_on_their_sides(const LimbBones& left, const LimbBones& right) {
    const glm::vec3 across = joints_.level(right.upper, left.upper);
    const bool hips_apart = glm::length(across) > 1e-3F * joints_.height;
    if (!hips_apart || glm::dot(across, joints_.level(right.end, left.end)) <= 0.0F) {
      doubt("the legs that are called left and right do not lie beside each other, so none is used");
      return;
    }
    const glm::vec3 forward = glm::normalize(glm::cross(across, up));
    const std::optional<glm::vec3> toes = toe_direction(joints_, {left, right});
    if (toes && glm::dot(*toes, forward) < 0.0F) {
      doubt("the toes point back, so left and right of the legs seem swapped and none is used");
      return;
    }
    limbs_.left_leg = left;
    limbs_.right_leg = right;
    limbs_.forward = forward;
  }

  void keep_legs_by_shape(const LimbPair& legs) {
    const glm::vec3 across = glm::normalize(joints_.level(legs.second.upper, legs.first.upper));
    const glm::vec3 seen = toe_direction(joints_, legs).value_or(glm::vec3(0.0F, 0.0F, 1.0F));
    const glm::vec3 forward = seen - across * glm::dot(seen, across);
    if (glm::length(forward) < 0.5F) {
      doubt("legs without toes stand one before the other, so which way the body faces is not known");
      return;
    }
    const bool first_is_left = glm::dot(glm::cross(up, forward), across) > 0.0F;
    limbs_.left_leg = first_is_left ? legs.first : legs.second;
    limbs_.right_leg = first_is_left ? legs.second : legs.first;
    limbs_.forward = glm::normalize(forward);
  }

  bool lies_left_of(const LimbBones& left, const LimbBones& right) const {
    return glm::dot(joints_.level(right.upper, left.upper), glm::cross(up, limbs_.forward)) > 0.0F;
  }

  void find_arms() {
    std::optional<LimbBones> left = find_named(arm_words, BodySide::left);
    std::optional<LimbBones> right = find_named(arm_words, BodySide::right);
    const bool by_shape = !left && !right && limbs_.left_leg && !limbs_.named;
    if (by_shape) {
      const auto arms = find_arm_shapes(joints_, {*limbs_.left_leg, *limbs_.right_leg});
      if (!arms) return doubt("no pair of arms was found by name or by shape");
      const bool first_is_left = lies_left_of(arms->first, arms->second);
      left = first_is_left ? arms->first : arms->second;
      right = first_is_left ? arms->second : arms->first;
    }
    if (left && right && !lies_left_of(*left, *right)) {
      return doubt("the arms lie on the other side than their names say, so none is used");
    }
    limbs_.left_arm = left;
    limbs_.right_arm = right;
  }

  int first_called(BodyPart part) const {
    for (int bone = 0; bone < bone_count(); ++bone) {
      if (name(bone).part == part && name(bone).side == BodySide::none) return bone;
    }
    return -1;
  }

  void find_trunk() {
    const bool has_legs = limbs_.left_leg.has_value();
    const int pelvis = has_legs
                           ? common_ancestor(skeleton_, parent(limbs_.left_leg->upper), parent(limbs_.right_leg->upper))
                           : first_called(BodyPart::pelvis);
    if (pelvis < 0) return doubt("no pelvis was found, so neither are spine and head");
    limbs_.pelvis = pelvis;
    int head = first_called(BodyPart::head);
    if (head < 0 && limbs_.left_arm && limbs_.right_arm) {
      head = find_head_shape(joints_, *limbs_.left_arm, *limbs_.right_arm);
    }
    if (head < 0 || head == pelvis || !is_below(skeleton_, head, pelvis)) {
      return doubt("no head was found above the pelvis");
    }
    limbs_.head = head;
    for (int bone = parent(head); bone != pelvis; bone = parent(bone)) {
      if (name(bone).part != BodyPart::pelvis) limbs_.spine.push_back(bone);
    }
    std::ranges::reverse(limbs_.spine);
  }

  const Skeleton& skeleton_;
  JointMap joints_;
  std::vector<LimbName> names_;
  Limbs limbs_;
};

}  // namespace

Limbs find_limbs(const Skeleton& skeleton) { return LimbFinder(skeleton).find(); }

}  // namespace throng::anim
