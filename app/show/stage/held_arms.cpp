#include "app/show/stage/held_arms.h"

#include <algorithm>
#include <memory>

#include "engine/anim/agent/cross_fade_channel.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::app {
namespace {

constexpr Ticks arm_fade = ticks_per_second * 3 / 10;
constexpr int not_made = -2;

using anim::BodyRole;

/// The joints below which an arm's clip is played. Both hands are on a bar and on a camera, and the head looks at a
/// phone.
std::vector<BodyRole> parts_of(Role arm) {
  switch (arm) {
    case Role::push:
    case Role::take_picture:
      return {BodyRole::left_shoulder, BodyRole::right_shoulder};
    case Role::lead:
      return {BodyRole::left_shoulder};
    case Role::hold_phone:
      return {BodyRole::right_shoulder, BodyRole::neck};
    default:
      return {BodyRole::right_shoulder};
  }
}

/// A skeleton without collar bones begins its arms a joint later.
int bone_of(const anim::RigMap& map, BodyRole part) {
  const int bone = map.bones[anim::index_of(part)];
  if (bone >= 0) return bone;
  if (part == BodyRole::left_shoulder) return map.bones[anim::index_of(BodyRole::left_upper_arm)];
  return part == BodyRole::right_shoulder ? map.bones[anim::index_of(BodyRole::right_upper_arm)] : bone;
}

/// Drinks and pictures come with the roles of those names; in between the arm waits at the first pose of their clips.
bool waits(Role arm) { return arm == Role::drink || arm == Role::take_picture; }

ArmClip clip_of_arm(const CharacterRoles& roles, Role arm) {
  const bool steps = arm == Role::push || arm == Role::stick;
  return {.clip = roles.clip(arm), .speed = waits(arm) ? 0.0 : 1.0, .step_clip = steps ? roles.clip(Role::walk) : -1};
}

}  // namespace

HeldArms::HeldArms(std::span<const CharacterSource> characters, anim::AnimationSystem& system)
    : characters_(characters), system_(&system), masks_(characters.size()) {
  for (auto& masks : masks_) masks.fill(not_made);
}

int HeldArms::mask_of(std::size_t character, Role arm) {
  int& mask = masks_[character][index_of(arm)];
  if (mask != not_made) return mask;
  mask = anim::PlayRequest::no_mask;
  const anim::Skeleton& skeleton = characters_[character].character->skeleton;
  const anim::RigMap map = anim::find_rig(skeleton);
  std::vector<anim::SubtreeWeight> arms;
  for (const BodyRole part : parts_of(arm)) {
    if (const int bone = bone_of(map, part); bone >= 0) arms.push_back({.bone = bone});
  }
  if (arms.empty()) return mask;
  const auto number = static_cast<std::uint32_t>(character);
  mask = system_->characters().add_mask(anim::BoneMask(role_names.at(index_of(arm)), skeleton, arms), number);
  return mask;
}

void HeldArms::reset(const Crowd& crowd) {
  for (std::uint32_t agent = 0; agent < arm_of_.size(); ++agent) {
    anim::Agent had = system_->agent(agent);
    if (arm_of_[agent] != none && had.exists()) had.remove_channel(arms_[arm_of_[agent]].channel);
  }
  arm_of_.assign(crowd.size(), none);
  arms_.clear();
  shown_.clear();
  const std::span<const HeldThing> things = crowd.minds().things();
  for (std::uint32_t agent = 0; agent < things.size(); ++agent) give(crowd, agent, things[agent]);
  shown_.reserve(arms_.size());
}

void HeldArms::give(const Crowd& crowd, std::uint32_t agent, HeldThing thing) {
  const auto arm = app::arm_of(thing);
  if (!arm) return;
  const std::size_t character = crowd.characters()[agent];
  const CharacterRoles& roles = characters_[character].roles;
  const int mask = roles.clip(*arm) == no_clip ? anim::PlayRequest::no_mask : mask_of(character, *arm);
  if (mask == anim::PlayRequest::no_mask) return;
  const ArmClip clip = clip_of_arm(roles, *arm);
  const auto channel =
      system_->agent(agent).add_channel(std::make_unique<ArmChannel>(clip), {.weight = 0.0F, .mask = mask});
  if (!channel) return;  // a local store of a fixed size has no room
  arm_of_[agent] = static_cast<std::uint32_t>(arms_.size());
  arms_.push_back({.channel = *channel, .keeps_step = clip.step_clip >= 0});
}

void HeldArms::turn_on(std::uint32_t agent, Arm& arm, bool at_once) {
  if (arm.turn == Turn::on) return;
  if (arm.turn == Turn::off) {
    [[maybe_unused]] const Status turned =
        system_->agent(agent).change<ArmChannel>(arm.channel, [](ArmChannel& channel) { channel.turn(true); });
    shown_.push_back(agent);
  }
  arm.turn = Turn::on;
  system_->agent(agent).set_channel_weight(arm.channel, 1.0F, at_once ? Ticks{} : arm_fade);
}

void HeldArms::turn_off(std::uint32_t agent, Arm& arm) {
  if (arm.turn != Turn::on) return;
  arm.turn = Turn::leaving;
  arm.gone_at = system_->clock() + arm_fade;
  system_->agent(agent).set_channel_weight(arm.channel, 0.0F, arm_fade);
}

/// Lets go at once where the agent is no longer near. Returns whether it stays among the shown agents.
bool HeldArms::goes_on(std::uint32_t agent) {
  Arm& arm = arms_[arm_of_[agent]];
  const bool is_near = arm.near_in == frame_;
  if (!is_near || (arm.turn == Turn::leaving && system_->clock() >= arm.gone_at)) {
    anim::Agent own = system_->agent(agent);
    own.set_channel_weight(arm.channel, 0.0F);
    [[maybe_unused]] const Status turned =
        own.change<ArmChannel>(arm.channel, [](ArmChannel& channel) { channel.turn(false); });
    arm.turn = Turn::off;
    return false;
  }
  if (arm.keeps_step) {
    [[maybe_unused]] const Status stepped = system_->agent(agent).change<ArmChannel>(arm.channel, [](ArmChannel&) {});
  }
  return true;
}

void HeldArms::show(const Crowd& crowd, std::span<const anim::VisibleAgent> near, std::span<const std::uint8_t> away) {
  const std::uint32_t before = frame_++;
  const std::span<const HeldThing> things = crowd.minds().things();
  for (const anim::VisibleAgent& seen : near) {
    const std::uint32_t agent = seen.agent;
    if (arm_of_[agent] == none) continue;
    Arm& arm = arms_[arm_of_[agent]];
    const bool was_near = arm.near_in == before && before != 0;
    if (!was_near && seen.pixels_tall < pixels_to_begin) continue;
    arm.near_in = frame_;
    const bool is_away = !away.empty() && away[agent] != 0;
    if (!is_away && arm_lies_over(things[agent], crowd.minds().roles()[agent])) {
      turn_on(agent, arm, !was_near);
    } else {
      turn_off(agent, arm);
    }
  }
  std::erase_if(shown_, [&](std::uint32_t agent) { return !goes_on(agent); });
}

void HeldArms::find_shown() {
  shown_.clear();
  for (std::uint32_t agent = 0; agent < arm_of_.size(); ++agent) {
    if (arm_of_[agent] == none) continue;
    Arm& arm = arms_[arm_of_[agent]];
    const auto* channel = system_->agent(agent).channel<ArmChannel>(arm.channel);
    const bool plays = channel != nullptr && channel->is_on();
    arm.turn = plays ? Turn::on : Turn::off;
    if (plays) shown_.push_back(agent);
  }
}

}  // namespace throng::app
