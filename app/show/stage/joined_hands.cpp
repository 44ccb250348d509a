#include "app/show/stage/joined_hands.h"

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

constexpr Ticks hand_fade = ticks_per_second * 3 / 10;
constexpr float stretched_to_begin = 0.93F, stretched_to_go_on = 0.985F;  // of an arm's length
constexpr float comfortable = 1.0F;                                       // of an arm's length, from shoulder to palm
constexpr float least_aside = 0.10F, most_behind = 0.28F;  // metres of a wrist, beside and behind its owner's middle
constexpr float share_of_child = 0.25F;                    // of the way to its hand: a long arm hangs
constexpr float half_a_hand = 0.020F;                      // metres from the bones of a palm to its skin

/// A person's place on the ground, to which model space is turned and scaled.
struct HolderPlace {
  glm::vec3 position;
  glm::vec3 left, ahead;
  float scale;

  HolderPlace(const Crowd& crowd, std::uint32_t agent)
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
  // Cosine and sine of the angle at the wrist, between the forearm and the line to the shoulder. An arc cosine would
  // have other bits on other systems.
  const auto inner_angle = [&](float reach) {
    const float length = glm::length(forearm);
    const float cosine = (length * length + reach * reach - glm::dot(upper, upper)) / (2.0F * length * reach);
    const float held = std::clamp(cosine, -1.0F, 1.0F);
    return glm::vec2(held, std::sqrt(1.0F - held * held));
  };
  const glm::vec2 now = inner_angle(glm::length(before)), then = inner_angle(glm::distance(target, shoulder));
  const float cosine = glm::dot(then, now), sine = then.y * now.x - then.x * now.y;  // of the angle between the two
  return glm::normalize(glm::quat(1.0F + cosine, sine * (swing * glm::normalize(bends)))) * swing;
}

std::size_t levels_with_hands(const anim::Skeleton& skeleton) {
  const anim::Limbs limbs = anim::find_limbs(skeleton);
  if (!limbs.left_arm || !limbs.right_arm) return 0;
  const int last = std::max(limbs.left_arm->end, limbs.right_arm->end);
  const auto has_them = [last](int bones) { return last < bones; };
  return static_cast<std::size_t>(std::ranges::count_if(skeleton.level_bone_counts, has_them));
}

/// Returns the place, or the nearest to it that is so far from a shoulder at most.
glm::vec3 within(const glm::vec3& place, const glm::vec3& shoulder, float reach) {
  const glm::vec3 way = place - shoulder;
  const float far = glm::length(way);
  return far > reach ? shoulder + way * (reach / far) : place;
}

glm::vec3 mean_of(const anim::Stride& clip, std::size_t joint) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < anim::stride_instants; ++i) sum += clip.at(i, joint);
  return glm::vec3(sum / static_cast<double>(anim::stride_instants));
}

/// Returns the middle of the joints at which fingers begin; for a hand without fingers, the wrist.
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
    : LentProcesses(std::move(kinds), system), characters_(characters), rigs_(rigs) {
  for (std::size_t character = 0; character < characters.size(); ++character) {
    arms_.push_back({arm_of(character, Role::lead), arm_of(character, Role::led)});
    levels_with_hands_.push_back(levels_with_hands(characters[character].character->skeleton));
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
  const anim::Stride stride =
      anim::sample_stride(skeleton, source.character->clips[static_cast<std::size_t>(clip)], source.character->height);
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
  LentProcesses::reset(crowd.size());
  away_.assign(crowd.size(), 0);
  const std::span<const HeldThing> things = crowd.minds().things();
  for (std::uint32_t agent = 1; agent < things.size(); ++agent) {
    if (things[agent] != HeldThing::grown_up || things[agent - 1] != HeldThing::child) continue;
    const std::uint8_t grown_up = crowd.characters()[agent - 1], child = crowd.characters()[agent];
    const bool have_arms = arms_[grown_up][0].length > 0.0F && arms_[child][1].length > 0.0F;
    if (have_arms) pairs_.push_back({.grown_up = agent - 1, .child = agent, .characters = {grown_up, child}});
  }
  is_new_ = true;
}

void JoinedHands::go_back_to(const Moment& moment) {
  LentProcesses::go_back_to(moment);
  for (Pair& pair : pairs_) pair.meets = moment.wanted[pair.grown_up] != 0 && moment.wanted[pair.child] != 0;
}

bool JoinedHands::is_near(const Pair& pair, std::span<const anim::VisibleAgent> near) const {
  const float least = pair.meets ? pixels_to_go_on : pixels_to_begin;
  const auto is_seen = [&](std::uint32_t agent, std::size_t character) {
    const auto seen = std::ranges::lower_bound(near, agent, {}, &anim::VisibleAgent::agent);
    return seen != near.end() && seen->agent == agent && seen->pixels_tall >= least &&
           seen->bone_level < levels_with_hands_[character];
  };
  return is_seen(pair.grown_up, pair.characters[0]) && is_seen(pair.child, pair.characters[1]);
}

void JoinedHands::find(const Crowd& crowd, std::span<const anim::VisibleAgent> near) {
  for (Pair& pair : pairs_) {
    pair.meets = is_near(pair, near) && can_meet(crowd, pair);
    away_[pair.grown_up] = away_[pair.child] = pair.meets ? 0 : 1;
  }
}

/// The place lies between the palms as the clips have them, and not too far for either arm. The palm of the grown-up
/// faces back, the palm of the child ahead.
bool JoinedHands::can_meet(const Crowd& crowd, Pair& pair) const {
  const HolderPlace grown_up(crowd, pair.grown_up), child(crowd, pair.child);
  const Arm& leads = arms_[pair.characters[0]][0];
  const Arm& is_led = arms_[pair.characters[1]][1];
  glm::vec3 middle = glm::mix(grown_up.to_world(leads.palm), child.to_world(is_led.palm), share_of_child);
  middle = within(middle, child.to_world(is_led.shoulder), comfortable * child.scale * is_led.length);
  middle = within(middle, grown_up.to_world(leads.shoulder), comfortable * grown_up.scale * leads.length);
  const glm::vec3 apart = half_a_hand * grown_up.ahead;
  pair.grown_ups = wrist_for(leads, grown_up.to_model(middle + grown_up.scale * apart));
  pair.childs = wrist_for(is_led, child.to_model(middle - child.scale * apart));
  const float stretched = std::max(glm::distance(pair.grown_ups, leads.shoulder) / leads.length,
                                   glm::distance(pair.childs, is_led.shoulder) / is_led.length);
  const bool are_beside = pair.grown_ups.x > least_aside && pair.childs.x < -least_aside &&
                          std::min(pair.grown_ups.z, pair.childs.z) > -most_behind;
  return are_beside && stretched < (pair.meets ? stretched_to_go_on : stretched_to_begin);
}

void JoinedHands::join(const HeldArms& arms) {
  for (const Pair& pair : pairs_) {
    const bool join = pair.meets && arms.holds(pair.grown_up) && arms.holds(pair.child) &&
                      reach(pair.grown_up, arms_[pair.characters[0]][0], pair.grown_ups) &&
                      reach(pair.child, arms_[pair.characters[1]][1], pair.childs);
    if (join) continue;
    let_go(pair.grown_up, hand_fade);
    let_go(pair.child, hand_fade);
  }
  is_new_ = false;
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
  const Lent lent =
      lend(agent, [&](anim::EntityPools::Kind kind) { return anim::ReachProcess(kind, {.limb = arm.limb}); });
  if (lent == Lent::no) return false;
  change(agent, [&](anim::ReachProcess& hand) {
    hand.set_target(target);
    if (lent != Lent::still) hand.set_weight(1.0F, is_new_ ? Ticks{} : hand_fade);
  });
  return true;
}

}  // namespace throng::app
