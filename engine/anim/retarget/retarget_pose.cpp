#include "engine/anim/retarget/retarget_pose.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/retarget/two_bone_reach.h"

namespace throng::anim {

namespace {

/// Below this height over the leg's length, a sole stands and the hips come down for it, at most by as much.
constexpr double stands_below = 0.03;
constexpr double most_drop = 0.02;

/// Feet that stand apart are where they should be even if the shin ends so much short of them, over the leg's length.
constexpr double most_gap = 0.05;

/// Joints that a clip moves by less, over the leg's length, keep their place.
constexpr double least_stretch = 2e-4;

/// Returns the part of a turn that is about the vertical.
glm::dquat about_vertical(const glm::dquat& turn) {
  const double length = glm::length(glm::dvec2(turn.w, turn.y));
  return length > 1e-6 ? glm::dquat(turn.w / length, 0.0, turn.y / length, 0.0) : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

class PoseRetargeter {
 public:
  PoseRetargeter(const RetargetPlan& plan, const Skeleton& skeleton, const BodyPose& source,
                 std::span<StateTransform> locals)
      : plan_(plan), skeleton_(skeleton), source_(source), locals_(locals), wanted_(plan.bones.size()) {
    globals_.resize(plan.bones.size());
    for (const StateTransform& local : locals) rest_places_.push_back(local.position);
  }

  void pose() {
    for (std::size_t bone = 0; bone < plan_.bones.size(); ++bone) want_as_source(bone);
    if (plan_.hips >= 0) want_hips();
    place_all();
    if (plan_.legs.empty()) return;
    std::vector<glm::dvec3> targets;
    for (const FollowedLeg& leg : plan_.legs) targets.push_back(ankle_target(leg));
    lower_hips(targets);
    for (std::size_t leg = 0; leg < targets.size(); ++leg) reach_for(plan_.legs[leg], targets[leg]);
    place_all();
  }

 private:
  /// The wanted motion of a bone in model space; the rest follows from the bone above.
  struct Wanted {
    std::optional<glm::dquat> rotation;
    std::optional<glm::dvec3> place;
    glm::dvec3 moved{0.0};  ///< from where the rest transform puts it
  };

  Wanted& wanted(int bone) { return wanted_[static_cast<std::size_t>(bone)]; }
  glm::dvec3 place(int bone) const { return globals_[static_cast<std::size_t>(bone)][3]; }

  /// Takes a place of the source to ours.
  glm::dvec3 scaled(const glm::dvec3& place) const {
    return plan_.own_origin + plan_.turn * (plan_.scale * (place - plan_.source_origin));
  }

  void want_as_source(std::size_t bone) {
    const FollowedBone& followed = plan_.bones[bone];
    if (followed.source < 0) return;
    wanted_[bone].rotation = plan_.turn * source_.rotation(followed.source) * followed.from_source;
    if (!followed.carries_hips) {
      wanted_[bone].moved = stretched(followed);
      return;
    }
    const glm::dvec3 moved = source_.place(followed.source) - followed.source_place;
    wanted_[bone].place = followed.own_place + plan_.turn * (plan_.scale * moved);
  }

  /// Returns how far the clip moves a joint from its place in the body, scaled: limbs that stretch, hips that shift.
  glm::dvec3 stretched(const FollowedBone& followed) const {
    if (followed.source_parent < 0) return glm::dvec3(0.0);
    const glm::dvec3 way = source_.place(followed.source) - source_.place(followed.source_parent);
    const glm::dvec3 moved = way - source_.rotation(followed.source_parent) * followed.source_offset;
    const glm::dvec3 own = plan_.turn * (plan_.scale * moved);
    return glm::length(own) > least_stretch * plan_.leg_length ? own : glm::dvec3(0.0);
  }

  void want_hips() {
    const glm::dvec3 joints = 0.5 * (source_.place(plan_.source_joints[0]) + source_.place(plan_.source_joints[1]));
    Wanted& hips = wanted(plan_.hips);
    const glm::dvec3 moved = 0.5 * (wanted(plan_.own_joints[0]).moved + wanted(plan_.own_joints[1]).moved);
    hips.place = scaled(joints) - *hips.rotation * plan_.hips_to_joints - moved;
  }

  void place_all() {
    for (std::size_t b = 0; b < plan_.bones.size(); ++b) {
      const Bone& bone = skeleton_.bones[b];
      const glm::dmat4 above =
          bone.parent < 0 ? bone.prefix : globals_[static_cast<std::size_t>(bone.parent)] * bone.prefix;
      if (wanted_[b].rotation) {
        locals_[b].rotation = glm::normalize(glm::conjugate(rotation_of(above)) * *wanted_[b].rotation);
      }
      if (wanted_[b].moved != glm::dvec3(0.0)) {
        locals_[b].position = rest_places_[b] + glm::inverse(glm::dmat3(above)) * wanted_[b].moved;
      }
      if (wanted_[b].place) locals_[b].position = glm::inverse(above) * glm::dvec4(*wanted_[b].place, 1.0);
      globals_[b] = above * compose(locals_[b]);
    }
  }

  /// Returns where the lowest point of the sole is below the ankle.
  static double lowest_of(const std::array<glm::dvec3, 2>& sole, const glm::dquat& foot) {
    return std::min((foot * sole[0]).y, (foot * sole[1]).y);
  }

  double sole_height(const FollowedLeg& leg) const {
    const double lowest =
        source_.place(leg.source.end).y + lowest_of(leg.source_sole, source_.rotation(leg.source.end));
    return plan_.scale * (lowest - plan_.source_origin.y);
  }

  /// The ankle is where the source's is, scaled, and as much further out as our hips are wider. That way out turns with
  /// the foot, which does not turn while it stands. The sole is as high as the source's.
  glm::dvec3 ankle_target(const FollowedLeg& leg) {
    const glm::dquat turned = *wanted(leg.own.end).rotation * glm::conjugate(leg.own_foot);
    glm::dvec3 target = scaled(source_.place(leg.source.end)) + about_vertical(turned) * leg.wider;
    target.y = plan_.own_origin.y + sole_height(leg) - lowest_of(leg.own_sole, *wanted(leg.own.end).rotation);
    return target;
  }

  LegPlaces places_of(const FollowedLeg& leg) {
    LegPlaces places{.hip = place(leg.own.upper), .knee = place(leg.own.middle), .ankle = place(leg.own.end)};
    if (leg.own.end_stands_apart) {
      places.ankle = places.knee + rotation_of(globals_[static_cast<std::size_t>(leg.own.middle)]) * leg.shin;
    }
    return places;
  }

  void lower_hips(const std::vector<glm::dvec3>& targets) {
    double drop = 0.0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const FollowedLeg& leg = plan_.legs[i];
      if (sole_height(leg) > stands_below * plan_.leg_length) continue;
      drop = std::max(drop, drop_to_reach(places_of(leg), targets[i]));
    }
    drop = std::min(drop, most_drop * plan_.leg_length);
    if (drop <= 0.0 || plan_.hips < 0) return;
    wanted(plan_.hips).place->y -= drop;
    place_all();
  }

  void reach_for(const FollowedLeg& leg, const glm::dvec3& target) {
    const LegPlaces places = places_of(leg);
    const glm::dquat hips = plan_.hips < 0 ? glm::dquat(1.0, 0.0, 0.0, 0.0) : *wanted(plan_.hips).rotation;
    const LegTurns turns = reach(places, target, hips * plan_.forward_in_hips);
    wanted(leg.own.upper).rotation = turns.upper * *wanted(leg.own.upper).rotation;
    wanted(leg.own.middle).rotation = turns.lower * *wanted(leg.own.middle).rotation;
    if (!leg.own.end_stands_apart) return;
    const bool is_near = glm::distance(turns.ankle, target) <= most_gap * plan_.leg_length;
    wanted(leg.own.end).place = is_near ? target : turns.ankle;
  }

  const RetargetPlan& plan_;
  const Skeleton& skeleton_;
  const BodyPose& source_;
  std::span<StateTransform> locals_;
  std::vector<Wanted> wanted_;
  std::vector<glm::dvec3> rest_places_;
  std::vector<glm::dmat4> globals_;
};

}  // namespace

void retarget_pose(const RetargetPlan& plan, const Skeleton& skeleton, const BodyPose& source,
                   std::span<StateTransform> locals) {
  PoseRetargeter(plan, skeleton, source, locals).pose();
}

}  // namespace throng::anim
