#include "app/character/body_parts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

#include "app/character/bone_lod.h"
#include "app/character/rig_table.h"
#include "app/character/source.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/rig/ragdoll_bones.h"
#include "engine/anim/rig/rig_map.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

using RigPart = anim::BodyRole;

// A person falls with these; the rest of a body may be missing.
constexpr RigPart parts_that_fall[] = {RigPart::left_upper_arm,  RigPart::right_upper_arm, RigPart::left_lower_arm,
                                       RigPart::right_lower_arm, RigPart::left_upper_leg,  RigPart::right_upper_leg,
                                       RigPart::left_lower_leg,  RigPart::right_lower_leg};

// Gives bones their parts. It checks nothing, because these choices were checked when a person made them.
void give_parts(std::span<const RigChoice> parts, std::span<const std::string> keys, anim::Skeleton& skeleton) {
  for (const auto& [role, key] : parts) {
    for (anim::Bone& bone : skeleton.bones) {
      if (bone.role == role) bone.role.reset();
    }
    const auto found = std::ranges::find(keys, key);
    if (found != keys.end()) skeleton.bones[static_cast<std::size_t>(found - keys.begin())].role = role;
  }
}

void take_parts_back(anim::Skeleton& skeleton) {
  for (anim::Bone& bone : skeleton.bones) bone.role.reset();
}

/// Returns the map of the skeleton where a person says nothing about `part`.
anim::RigMap map_without(const CharacterSource& source, std::span<const std::string> keys, RigPart part) {
  anim::Skeleton skeleton = skeleton_in_file(source);
  std::vector<RigChoice> others = source.rig;
  std::erase_if(others, [&](const RigChoice& choice) { return choice.role == part; });
  give_parts(others, keys, skeleton);
  return anim::find_rig(skeleton);
}

std::string how_it_falls(const anim::Skeleton& skeleton, const anim::RigMap& map, const anim::CharacterRigs& rigs) {
  if (!rigs.ragdoll()) return "it cannot fall";
  if (!anim::choose_humanoid_bones(skeleton).empty()) return "it falls as a person";
  std::vector<std::string> missing;
  for (const RigPart part : parts_that_fall) {
    if (map.at(part) < 0) missing.push_back(words_of(part));
  }
  return "it falls, but not as a person" +
         (missing.empty() ? ", as its limbs are out of place" : ", for want of " + joined(missing, ", ", " and "));
}

/// Returns a sentence about the skeleton without its name, which is beside it already.
std::string without_name(std::string sentence, const std::string& name) {
  const std::string subject = "skeleton '" + name + "'", of_it = " of " + subject;
  if (const std::size_t at = sentence.find(of_it); at != std::string::npos) sentence.erase(at, of_it.size());
  if (sentence.starts_with(subject + ": ")) return sentence.substr(subject.size() + 2);
  return sentence.starts_with(subject) ? "it" + sentence.substr(subject.size()) : sentence;
}

std::string what_follows(const anim::Skeleton& skeleton, const anim::RigMap& map, const anim::CharacterRigs& rigs) {
  std::string text = rigs.foot_placement() ? "Feet are placed" : "Feet are not placed";
  text += rigs.look_at() ? "; it can look at things; " : "; it has no gaze; ";
  text += how_it_falls(skeleton, map, rigs) + ".";
  std::vector<std::string> reasons;
  for (const std::string& sentence : rigs.missing()) reasons.push_back(without_name(sentence, skeleton.name));
  if (!reasons.empty()) text += " Noted: " + joined(reasons, "; ", "; ") + ".";
  return text;
}

std::vector<RigChoice> said_as_before(std::span<const RigChoice> choices, std::span<const RigChoice> before) {
  std::vector<RigChoice> same;
  std::ranges::copy_if(choices, std::back_inserter(same),
                       [&](const RigChoice& choice) { return std::ranges::find(before, choice) != before.end(); });
  return same;
}

/// Puts a person's choices over guesses. A guess whose bone is chosen for another part gives way.
void put_over(std::span<const RigChoice> choices, std::span<const std::string> keys, PartBones& bones) {
  for (const auto& [role, key] : choices) {
    const auto bone = static_cast<int>(std::ranges::find(keys, key) - keys.begin());
    std::ranges::replace(bones, bone, -1);
    bones[anim::index_of(role)] = bone;
  }
}

}  // namespace

anim::Skeleton skeleton_in_file(const CharacterSource& source) {
  anim::Skeleton skeleton = source.model.skeleton;
  take_parts_back(skeleton);
  give_parts(source.parts_in_file, bone_keys(skeleton), skeleton);
  return skeleton;
}

BodyParts body_parts(const CharacterSource& source, const anim::CharacterRigs& rigs) {
  const anim::Skeleton& skeleton = source.model.skeleton;
  const std::vector<std::string> keys = bone_keys(skeleton);
  const anim::RigMap map = anim::find_rig(skeleton);
  BodyParts parts{.bones = keys,
                  .chosen = source.rig,
                  .guessed = {},
                  .follows = what_follows(skeleton, map, rigs),
                  .refused = {},
                  .refusal = {}};
  std::ranges::sort(parts.bones);
  const auto key_of = [&](int bone) { return bone < 0 ? std::string() : keys[static_cast<std::size_t>(bone)]; };
  for (std::size_t role = 0; role < anim::body_role_count; ++role) {
    const auto part = static_cast<RigPart>(role);
    const bool is_said = std::ranges::find(source.rig, part, &RigChoice::role) != source.rig.end();
    parts.guessed[role] = key_of(is_said ? map_without(source, keys, part).at(part) : map.at(part));
  }
  return parts;
}

Status take_rig(CharacterSource& source, const std::vector<RigChoice>& choices) {
  anim::Skeleton& skeleton = source.model.skeleton;
  std::vector<anim::Bone> before = skeleton.bones;
  const std::vector<std::string> keys = bone_keys(skeleton);
  take_parts_back(skeleton);
  give_parts(source.parts_in_file, keys, skeleton);
  give_parts(said_as_before(choices, source.rig), keys, skeleton);
  PartBones bones = anim::find_rig(skeleton).bones;
  Status taken = choose_bones(choices, skeleton);
  if (taken) {
    put_over(choices, keys, bones);
    if (const auto misplaced = misplaced_part(choices, bones, skeleton)) taken = Error{*misplaced};
  }
  if (taken) {
    source.rig = choices;
  } else {
    skeleton.bones = std::move(before);
  }
  return taken;
}

}  // namespace throng::app
