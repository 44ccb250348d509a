#include "app/stage/joined_hands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/anim/bake/stride.h"
#include "engine/anim/rig/limbs.h"

namespace throng::app {
namespace {

constexpr anim::Ticks hand_fade = anim::ticks_per_second * 3 / 10;
constexpr float stretched_to_begin = 0.93F, stretched_to_go_on = 0.985F;  // of an arm's length
constexpr float share_of_child = 0.25F;                                   // of the way to its hand: a long arm hangs
constexpr float half_a_hand = 0.020F;                                     // metres from the bones of a palm to its skin

/// A person's place on the ground, to which model space is turned and scaled.
struct Stand {
  glm::vec3 position;
  glm::vec3 left, ahead;
  float scale;

  Stand(const Crowd& crowd, std::uint32_t agent)
      : position(crowd.positions()[agent]),
        left(crowd.headings()[agent].cosine, 0.0F, -crowd.headings()[agent].sine),
        ahead(crowd.headings()[agent].sine, 0.0F, crowd.headings()[agent].cosine),
        scale(crowd.scales()[agent]) {}

  glm::vec3 to_world(const glm::vec3& place) const {
    return position + scale * (place.x * left + glm::vec3(0.0F, place.y, 0.0F) + place.z * ahead);
  }
  glm::vec3 to_model(const glm::vec3& place) const {
    const glm::vec3 way = (place - position) / scale;
    return {glm::dot(way, left), way.y, glm::dot(way, ahead)};
  }
};

/// Returns by how much a forearm turns when its arm reaches for a place in the plane that it bends in.
glm::quat turn_of_forearm(const std::array<glm::vec3, 3>& joints, const glm::vec3& target) {
  const auto& [shoulder, elbow, wrist] = joints;
  const glm::vec3 upper = elbow - shoulder, forearm = wrist - elbow, before = wrist - shoulder;
  const glm::quat swing(glm::normalize(before), glm::normalize(target - shoulder));
  const glm::vec3 bends = glm::cross(upper, forearm);
  if (glm::length(bends) < 1e-6F) return swing;
  const auto inner_angle = [&](float reach) {  // at the wrist, between the forearm and the line to the shoulder
    const float length = glm::length(forearm);
    const float cosine = (length * length + reach * reach - glm::dot(upper, upper)) / (2.0F * length * reach);
    return std::acos(std::clamp(cosine, -1.0F, 1.0F));
  };
  const float more = inner_angle(glm::distance(target, shoulder)) - inner_angle(glm::length(before));
  return glm::angleAxis(more, swing * glm::normalize(bends)) * swing;
}

glm::vec3 mean_of(const anim::Stride& clip, std::size_t joint) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < anim::stride_instants; ++i) sum += clip.at(i, joint);
  return glm::vec3(sum / static_cast<double>(anim::stride_instants));
}

/// Returns the middle of the joints at which fingers begin; that of a hand without fingers is its wrist.
glm::vec3 palm_of(const anim::Stride& clip, const anim::Skeleton& skeleton, int wrist) {
  glm::vec3 sum(0.0F);
  float fingers = 0.0F;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    if (skeleton.bones[static_cast<std::size_t>(bone)].parent != wrist) continue;
    sum += mean_of(clip, static_cast<std::size_t>(bone));
    fingers += 1.0F;
  }
  return fingers > 0.0F ? sum / fingers : mean_of(clip, static_cast<std::size_t>(wrist));
}

}  // namespace

JoinedHands::JoinedHands(std::span<const CharacterSource> characters,
                         std::span<const std::unique_ptr<anim::CharacterRigs>> rigs,
                         std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system)
    : characters_(characters), rigs_(rigs), lent_(std::move(kinds), system) {
  for (std::size_t character = 0; character < characters.size(); ++character) {
    arms_.push_back({arm_of(character, Role::lead), arm_of(character, Role::led)});
  }
}

JoinedHands::Arm JoinedHands::arm_of(std::size_t character, Role role) const {
  using Limb = anim::CharacterRigs::Limb;
  const CharacterSource& source = characters_[character];
  const anim::Skeleton& skeleton = source.character->skeleton;
  const int clip = source.roles.clip(role);
  const anim::Limbs limbs = anim::find_limbs(skeleton);
  const auto& bones = role == Role::lead ? limbs.left_arm : limbs.right_arm;
  const auto limb = rigs_[character]->limb(role == Role::lead ? Limb::left_arm : Limb::right_arm);
  if (clip == no_clip || !bones || !limb) return {};
  const anim::Stride stride = anim::sample_stride(
      skeleton, source.character->clips[static_cast<std::size_t>(clip)].keyframe(), source.character->height);
  const auto place = [&](int bone) { return mean_of(stride, static_cast<std::size_t>(bone)); };
  Arm arm{.limb = *limb,
          .length = 0.0F,
          .shoulder = place(bones->upper),
          .elbow = place(bones->middle),
          .wrist = place(bones->end),
          .palm = {}};
  arm.length = glm::distance(arm.shoulder, arm.elbow) + glm::distance(arm.elbow, arm.wrist);
  arm.palm = palm_of(stride, skeleton, bones->end);
  return arm;
}

void JoinedHands::reset(const Crowd& crowd) {
  pairs_.clear();
  lent_.reset(crowd.size());
  const std::span<const Held> things = things_of(crowd);
  for (std::uint32_t agent = 1; agent < things.size(); ++agent) {
    if (things[agent] != Held::grown_up || things[agent - 1] != Held::child) continue;
    const bool have_arms = arm(crowd, agent - 1, 0).length > 0.0F && arm(crowd, agent, 1).length > 0.0F;
    if (have_arms) pairs_.push_back({.grown_up = agent - 1, .child = agent});
  }
  is_new_ = true;
}

void JoinedHands::go_back_to(const Moment& moment) {
  lent_.go_back_to(moment);
  for (Pair& pair : pairs_) pair.joined = moment.wanted[pair.grown_up] != 0 && moment.wanted[pair.child] != 0;
}

bool JoinedHands::is_near(const Pair& pair, const HeldArms& arms, std::span<const anim::VisibleAgent> visible) const {
  const float least = pair.joined ? pixels_to_go_on : pixels_to_begin;
  return std::ranges::all_of(std::array{pair.grown_up, pair.child}, [&](std::uint32_t agent) {
    const auto seen = std::ranges::lower_bound(visible, agent, {}, &anim::VisibleAgent::agent);
    return seen != visible.end() && seen->agent == agent && seen->pixels_tall >= least && arms.holds(agent);
  });
}

void JoinedHands::join(const Crowd& crowd, const HeldArms& arms, std::span<const anim::VisibleAgent> visible) {
  for (Pair& pair : pairs_) {
    if (is_near(pair, arms, visible)) {
      join(crowd, pair);
    } else {
      pair.joined = false;
    }
    if (pair.joined) continue;
    lent_.let_go(pair.grown_up, hand_fade);
    lent_.let_go(pair.child, hand_fade);
  }
  is_new_ = false;
}

/// The place lies between the palms as the clips have them. The palm of the grown-up faces back, that of the child
/// ahead.
void JoinedHands::join(const Crowd& crowd, Pair& pair) {
  const Stand grown_up(crowd, pair.grown_up), child(crowd, pair.child);
  const Arm& leads = arm(crowd, pair.grown_up, 0);
  const Arm& is_led = arm(crowd, pair.child, 1);
  const glm::vec3 middle = glm::mix(grown_up.to_world(leads.palm), child.to_world(is_led.palm), share_of_child);
  const glm::vec3 apart = half_a_hand * grown_up.ahead;
  const glm::vec3 first = wrist_for(leads, grown_up.to_model(middle + grown_up.scale * apart));
  const glm::vec3 second = wrist_for(is_led, child.to_model(middle - child.scale * apart));
  const float stretched = std::max(glm::distance(first, leads.shoulder) / leads.length,
                                   glm::distance(second, is_led.shoulder) / is_led.length);
  pair.joined = stretched < (pair.joined ? stretched_to_go_on : stretched_to_begin) &&
                reach(pair.grown_up, leads, first) && reach(pair.child, is_led, second);
}

/// The hand keeps its angle to the forearm, which turns as the arm reaches.
glm::vec3 JoinedHands::wrist_for(const Arm& arm, const glm::vec3& palm) {
  constexpr int tries = 3;
  const glm::vec3 hand = arm.palm - arm.wrist;
  glm::vec3 wrist = palm - hand;
  for (int i = 0; i < tries; ++i) {
    wrist = palm - turn_of_forearm({arm.shoulder, arm.elbow, arm.wrist}, wrist) * hand;
  }
  return wrist;
}

bool JoinedHands::reach(std::uint32_t agent, const Arm& arm, const glm::vec3& target) {
  using Lent = LentProcesses<anim::ReachProcess>::Lent;
  const Lent lent =
      lent_.lend(agent, [&](anim::EntityPools::Kind kind) { return anim::ReachProcess(kind, {.limb = arm.limb}); });
  if (lent == Lent::no) return false;
  lent_.change(agent, [&](anim::ReachProcess& hand) {
    hand.set_target(target);
    if (lent != Lent::still) hand.set_weight(1.0F, is_new_ ? anim::Ticks{} : hand_fade);
  });
  return true;
}

}  // namespace throng::app
