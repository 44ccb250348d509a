#include "app/character/rig_table.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "app/character/bone_lod.h"
#include "app/files/nearest_names.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

using RigPart = anim::BodyRole;

// Each chain goes from the hips outwards, so no part is above one before it.
constexpr RigPart trunk[] = {RigPart::hips,        RigPart::spine, RigPart::chest,
                             RigPart::upper_chest, RigPart::neck,  RigPart::head};
constexpr RigPart left_arm[] = {RigPart::hips, RigPart::left_shoulder, RigPart::left_upper_arm, RigPart::left_lower_arm,
                                RigPart::left_hand};
constexpr RigPart right_arm[] = {RigPart::hips, RigPart::right_shoulder, RigPart::right_upper_arm,
                                 RigPart::right_lower_arm, RigPart::right_hand};
constexpr RigPart left_leg[] = {RigPart::hips, RigPart::left_upper_leg, RigPart::left_lower_leg, RigPart::left_foot,
                                RigPart::left_toes};
constexpr RigPart right_leg[] = {RigPart::hips, RigPart::right_upper_leg, RigPart::right_lower_leg, RigPart::right_foot,
                                 RigPart::right_toes};
constexpr std::span<const RigPart> chains[] = {trunk, left_arm, right_arm, left_leg, right_leg};

bool is_above(const anim::Skeleton& skeleton, int bone, int other) {
  if (bone < 0) return false;
  while (other > bone) other = skeleton.bones[static_cast<std::size_t>(other)].parent;
  return other == bone;
}

bool is_chosen(std::span<const RigChoice> choices, RigPart part) {
  return std::ranges::find(choices, part, &RigChoice::role) != choices.end();
}

struct PlacedPart {
  RigPart part;
  int bone;
};

std::string refusal(const anim::Skeleton& skeleton, const PlacedPart& chosen, const char* where,
                    const PlacedPart& other) {
  const std::vector<std::string> keys = bone_keys(skeleton);
  return keys[static_cast<std::size_t>(chosen.bone)] + " cannot be the " + words_of(chosen.part) + ": it is " + where +
         " " + keys[static_cast<std::size_t>(other.bone)] + ", the " + words_of(other.part);
}

}  // namespace

std::optional<std::string> read_rig_choices(const Json& rig, std::vector<RigChoice>& choices) {
  if (!rig.is_object()) return "\"rig\" must be an object of parts of the body and names of bones";
  for (const auto& [part, bone] : rig.members()) {
    const auto role = anim::body_role_named(part);
    if (!role) {
      return "\"rig\" has no part \"" + part + "\"; it knows " + joined(anim::body_role_names, ", ", " and ");
    }
    if (!bone.is<std::string>()) return "\"rig\": \"" + part + "\" must be the name of a bone";
    choices.push_back({*role, bone.get<std::string>()});
  }
  return {};
}

Json rig_json(std::span<const RigChoice> choices) {
  Json rig = Json::object();
  for (const auto& [role, bone] : choices) rig[anim::name_of(role)] = bone;
  return rig;
}

std::string words_of(anim::BodyRole role) {
  std::string words;
  for (const char letter : anim::name_of(role)) {
    const bool is_capital = letter >= 'A' && letter <= 'Z';
    if (is_capital) words += ' ';
    words += is_capital ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return words;
}

std::vector<RigChoice> said_parts(const anim::Skeleton& skeleton) {
  const std::vector<std::string> keys = bone_keys(skeleton);
  std::vector<RigChoice> parts;
  for (std::size_t bone = 0; bone < keys.size(); ++bone) {
    if (skeleton.bones[bone].role) parts.push_back({*skeleton.bones[bone].role, keys[bone]});
  }
  return parts;
}

std::optional<std::string> misplaced_part(std::span<const RigChoice> choices, const PartBones& bones,
                                          const anim::Skeleton& skeleton) {
  for (const std::span<const RigPart> chain : chains) {
    for (std::size_t lower = 1; lower < chain.size(); ++lower) {
      for (std::size_t upper = 0; upper < lower; ++upper) {
        const RigPart parts[] = {chain[upper], chain[lower]};
        const int upper_bone = bones[anim::index_of(parts[0])], lower_bone = bones[anim::index_of(parts[1])];
        const bool is_turned = is_above(skeleton, lower_bone, upper_bone);
        if (is_turned && is_chosen(choices, parts[1])) {
          return refusal(skeleton, {parts[1], lower_bone}, "above", {parts[0], upper_bone});
        }
        if (is_turned && is_chosen(choices, parts[0])) {
          return refusal(skeleton, {parts[0], upper_bone}, "below", {parts[1], lower_bone});
        }
      }
    }
  }
  return {};
}

Status choose_bones(std::span<const RigChoice> choices, anim::Skeleton& skeleton) {
  const std::vector<std::string> keys = bone_keys(skeleton);
  std::vector<anim::Bone> bones = skeleton.bones;
  PartBones chosen;
  chosen.fill(-1);
  for (const auto& [role, key] : choices) {
    const auto found = std::ranges::find(keys, key);
    if (found == keys.end()) {
      return Error{std::string(anim::name_of(role)) + "=" + key + ": the skeleton has no such bone; nearest are " +
                   nearest_names(key, keys)};
    }
    const auto bone = static_cast<int>(found - keys.begin());
    if (const auto* const other = std::ranges::find(chosen, bone); other != chosen.end()) {
      const auto part = static_cast<anim::BodyRole>(other - chosen.begin());
      return Error{key + " cannot be both the " + words_of(part) + " and the " + words_of(role) +
                   "; choose another bone for one of them"};
    }
    chosen[anim::index_of(role)] = bone;
    for (anim::Bone& each : bones) {
      if (each.role == role) each.role.reset();
    }
    bones[static_cast<std::size_t>(bone)].role = role;
  }
  if (const auto misplaced = misplaced_part(choices, chosen, skeleton)) return Error{*misplaced};
  skeleton.bones = std::move(bones);
  return Done{};
}

}  // namespace throng::app
