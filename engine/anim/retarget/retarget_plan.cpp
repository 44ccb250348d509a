#include "engine/anim/retarget/retarget_plan.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "engine/anim/base/elementary.h"
#include "engine/anim/retarget/body_pose.h"

namespace throng::anim {

namespace {

/// A bone whose direction says how it is held, and the bone that it points at.
struct PointingRoles {
  BodyRole bone, end;
};
constexpr std::array pointing_roles{PointingRoles{BodyRole::left_upper_arm, BodyRole::left_lower_arm},
                                    PointingRoles{BodyRole::left_lower_arm, BodyRole::left_hand},
                                    PointingRoles{BodyRole::left_upper_leg, BodyRole::left_lower_leg},
                                    PointingRoles{BodyRole::left_lower_leg, BodyRole::left_foot},
                                    PointingRoles{BodyRole::right_upper_arm, BodyRole::right_lower_arm},
                                    PointingRoles{BodyRole::right_lower_arm, BodyRole::right_hand},
                                    PointingRoles{BodyRole::right_upper_leg, BodyRole::right_lower_leg},
                                    PointingRoles{BodyRole::right_lower_leg, BodyRole::right_foot}};

/// Returns whole quarter turns about the vertical, since artists turn characters by no other angles.
glm::dquat quarter_turns(const glm::vec3& from, const glm::vec3& to) {
  const double angle = arc_tangent(static_cast<double>(to.x), static_cast<double>(to.z)) -
                       arc_tangent(static_cast<double>(from.x), static_cast<double>(from.z));
  const double quarter = std::numbers::pi / 2.0;
  return angle_axis(std::round(angle / quarter) * quarter, glm::dvec3(0.0, 1.0, 0.0));
}

class Planner {
 public:
  Planner(const Skeleton& from, const Skeleton& to, const RigMatch& match)
      : match_(match), source_(figure_of(from, match.from)), own_(figure_of(to, match.to)) {}

  RetargetPlan plan() {
    plan_.turn = quarter_turns(source_.rig.limbs.forward, own_.rig.limbs.forward);
    plan_.forward_in_hips = own_.rig.limbs.forward;
    plan_.leg_length = own_.leg_length();
    plan_.own_carriage = carriage_of(own_);
    plan_.source_carriage = carriage_of(source_);
    has_same_frames_ = have_same_frames();
    source_stands_ = !has_same_frames_ || stand_alike();
    if (!source_stands_) stand_source();
    plan_.scale = scale();
    plan_.source_origin = origin_of(source_);
    plan_.own_origin = origin_of(own_);
    plan_bones();
    plan_hips();
    for (const auto& [own, source] : both_legs()) plan_leg(*own, *source);
    return std::move(plan_);
  }

 private:
  int source_of(int bone) const { return bone < 0 ? -1 : match_.source_of[static_cast<std::size_t>(bone)]; }

  /// Leg over leg; without legs, height over height.
  double scale() const {
    if (own_.leg > 0.0 && source_.leg > 0.0) return own_.leg_length() / source_.leg_length();
    const double own = height_of(own_.pose), source = height_of(source_.pose);
    return source > 0.0 && own > 0.0 ? own / source : 1.0;
  }

  static glm::dvec3 hip_joints(const Figure& figure) {
    const int left = figure.rig.at(BodyRole::left_upper_leg), right = figure.rig.at(BodyRole::right_upper_leg);
    return 0.5 * (figure.pose.place(left) + figure.pose.place(right));
  }

  static bool has_hip_joints(const Figure& figure) {
    return figure.rig.at(BodyRole::left_upper_leg) >= 0 && figure.rig.at(BodyRole::right_upper_leg) >= 0;
  }

  /// A figure that stands far from its file's origin keeps that place.
  static glm::dvec3 origin_of(const Figure& figure) {
    glm::dvec3 origin(0.0, figure.ground, 0.0);
    if (!has_hip_joints(figure)) return origin;
    const glm::dvec3 hips = hip_joints(figure);
    if (glm::length(glm::dvec2(hips.x, hips.z)) > 0.5 * figure.leg_length()) origin = {hips.x, figure.ground, hips.z};
    return origin;
  }

  /// Says whether joints of both have the same axes: bones then point the same ways in their parents' frames, whatever
  /// pose the files rest in. So it is with all Mixamo rigs, whose files without a skin rest in the middle of a clip.
  bool have_same_frames() const {
    constexpr double alike = 0.99;  // cosine of 8 degrees
    int compared = 0, agree = 0;
    for (int bone = 0; bone < own_.skeleton.bone_count(); ++bone) {
      const int source = source_of(bone), parent = own_.skeleton.parent(bone);
      if (source < 0 || parent < 0 || source_.skeleton.parent(source) < 0) continue;
      if (source_of(parent) != source_.skeleton.parent(source)) continue;
      const glm::dvec3 own = in_parent(own_.pose, bone, parent);
      const glm::dvec3 other = in_parent(source_.pose, source, source_.skeleton.parent(source));
      if (glm::length(own) < 0.01 * plan_.leg_length || !(glm::length(other) > 0.0)) continue;
      ++compared;
      agree += glm::dot(glm::normalize(own), glm::normalize(other)) > alike ? 1 : 0;
    }
    constexpr int least = 8;
    return compared >= least && agree * 10 >= compared * 9;
  }

  /// Says whether the feet of both are turned alike in their reference poses, which then both stand.
  bool stand_alike() const {
    constexpr double alike = 0.985;  // cosine of half of 20 degrees
    for (const BodyRole role : {BodyRole::left_foot, BodyRole::right_foot}) {
      const int own = own_.rig.at(role), source = source_.rig.at(role);
      if (own < 0 || source < 0) continue;
      const glm::dquat other = plan_.turn * source_.pose.rotation(source);
      if (std::abs(glm::dot(own_.pose.rotation(own), other)) < alike) return false;
    }
    return true;
  }

  /// Takes the ground and the height of the ankles of a source that rests in the middle of a clip from our feet.
  void stand_source() {
    source_.ground = 0.0;
    source_.ankle = 0.0;
    double legs = 0.0;
    for (const auto& [own, source] : both_legs()) {
      source_.ankle -= (flat_foot(*own) * flat_sole(*own, *source)[0]).y;
      ++legs;
    }
    if (legs > 0.0) source_.ankle /= legs;
  }

  /// The legs that both have, ours first.
  std::vector<std::pair<const LimbBones*, const LimbBones*>> both_legs() const {
    std::vector<std::pair<const LimbBones*, const LimbBones*>> legs;
    const Figure& own = own_;
    const Figure& source = source_;
    if (own.left_leg && source.left_leg) legs.emplace_back(&*own.left_leg, &*source.left_leg);
    if (own.right_leg && source.right_leg) legs.emplace_back(&*own.right_leg, &*source.right_leg);
    return legs;
  }

  /// Returns how the source's foot is turned when it stands flat, as ours does in its reference pose.
  glm::dquat flat_foot(const LimbBones& own) const { return glm::conjugate(plan_.turn) * own_.pose.rotation(own.end); }

  /// Returns the source's sole by the way to its ball, and by how high our ball is above the ground.
  std::array<glm::dvec3, 2> flat_sole(const LimbBones& own, const LimbBones& source) const {
    const double smaller = own_.leg > 0.0 ? source_.leg / own_.leg : 1.0;
    const glm::dquat flat = flat_foot(own);
    glm::dvec3 ball(0.0);
    double ankle = own_.ankle * smaller;
    if (own.tip >= 0 && source.tip >= 0) {
      ball = flat * in_parent(source_.pose, source.tip, source.end);
      ankle = (own_.pose.place(own.tip).y - own_.ground) * smaller - ball.y;
    }
    return {glm::conjugate(flat) * glm::dvec3(0.0, -ankle, 0.0),
            glm::conjugate(flat) * glm::dvec3(ball.x, -ankle, ball.z)};
  }

  static glm::dvec3 in_parent(const BodyPose& pose, int bone, int parent) {
    return glm::conjugate(pose.rotation(parent)) * (pose.place(bone) - pose.place(parent));
  }

  void plan_bones() {
    plan_.bones.resize(match_.source_of.size());
    std::vector<glm::dquat> held(plan_.bones.size(), glm::dquat(1.0, 0.0, 0.0, 0.0));
    const int hips = own_.rig.at(BodyRole::hips);
    for (int bone = 0; bone < own_.skeleton.bone_count(); ++bone) {
      FollowedBone& followed = plan_.bones[static_cast<std::size_t>(bone)];
      const int parent = own_.skeleton.parent(bone);
      const glm::dquat above = parent < 0 ? glm::dquat(1.0, 0.0, 0.0, 0.0) : held[static_cast<std::size_t>(parent)];
      held[static_cast<std::size_t>(bone)] = above;
      followed.source = source_of(bone);
      if (followed.source < 0) continue;
      held[static_cast<std::size_t>(bone)] = how_held(bone, above);
      const glm::dquat& own = own_.pose.rotation(bone);
      if (!has_same_frames_) {
        const glm::dquat source = plan_.turn * source_.pose.rotation(followed.source);
        followed.from_source = glm::conjugate(source) * held[static_cast<std::size_t>(bone)] * own;
      }
      followed.carries_hips =
          hips < 0 ? parent < 0 || source_of(parent) < 0 : bone != hips && is_below(own_.skeleton, hips, bone);
      if (parent >= 0 && source_of(parent) >= 0 && source_of(parent) == source_.skeleton.parent(followed.source)) {
        followed.source_parent = source_.skeleton.parent(followed.source);
        followed.source_offset = in_parent(source_.pose, followed.source, followed.source_parent);
      }
      followed.source_place = source_.pose.place(followed.source);
      followed.own_place = own_.pose.place(bone);
    }
  }

  /// Returns the turn from how a bone of ours is held in its reference pose to how the source's is, as from arms that
  /// hang to arms stretched out. Feet stand flat in both, and the trunk is upright in both.
  glm::dquat how_held(int bone, const glm::dquat& above) const {
    for (const auto& [role, end] : pointing_roles) {
      if (own_.rig.at(role) != bone) continue;
      const int source = source_.rig.at(role);
      const int own_end = own_.rig.at(end), source_end = source_.rig.at(end);
      if (source != source_of(bone) || own_end < 0 || source_end < 0) return above;
      return turn_between(own_.pose.place(own_end) - own_.pose.place(bone),
                          plan_.turn * (source_.pose.place(source_end) - source_.pose.place(source)));
    }
    for (const auto& [own, source] : both_legs()) {
      if (bone == own->end || bone == own->tip) return foot_held(*own, *source);
    }
    for (const BodyRole role : {BodyRole::left_foot, BodyRole::left_toes, BodyRole::right_foot, BodyRole::right_toes}) {
      if (own_.rig.at(role) == bone) return {1.0, 0.0, 0.0, 0.0};
    }
    return above;
  }

  /// Returns the turn from how a foot of ours is held in its reference pose to how the source's is: none where both
  /// stand flat, else that between the ways to their balls.
  glm::dquat foot_held(const LimbBones& own, const LimbBones& source) const {
    constexpr double flat_alike = 0.26;  // sine of 15 degrees
    if (own.tip < 0 || source.tip < 0) return {1.0, 0.0, 0.0, 0.0};
    const glm::dvec3 own_way = own_.pose.place(own.tip) - own_.pose.place(own.end);
    const glm::dvec3 other_way = plan_.turn * (source_.pose.place(source.tip) - source_.pose.place(source.end));
    if (!(glm::length(own_way) > 0.0) || !(glm::length(other_way) > 0.0)) return {1.0, 0.0, 0.0, 0.0};
    const double tilt = glm::normalize(own_way).y - glm::normalize(other_way).y;
    return std::abs(tilt) < flat_alike ? glm::dquat(1.0, 0.0, 0.0, 0.0) : turn_between(own_way, other_way);
  }

  void plan_hips() {
    const int hips = own_.rig.at(BodyRole::hips);
    if (hips < 0 || source_of(hips) < 0 || !has_hip_joints(own_) || !has_hip_joints(source_)) return;
    plan_.hips = hips;
    plan_.forward_in_hips = glm::conjugate(own_.pose.rotation(hips)) * plan_.forward_in_hips;
    plan_.own_joints = {own_.rig.at(BodyRole::left_upper_leg), own_.rig.at(BodyRole::right_upper_leg)};
    plan_.source_joints = {source_.rig.at(BodyRole::left_upper_leg), source_.rig.at(BodyRole::right_upper_leg)};
    plan_.hips_to_joints = glm::conjugate(own_.pose.rotation(hips)) * (hip_joints(own_) - own_.pose.place(hips));
  }

  /// Returns the sole of a foot that `held` turns from where it stands flat.
  static std::array<glm::dvec3, 2> sole_of(const Figure& figure, const LimbBones& leg,
                                           const glm::dquat& held = {1.0, 0.0, 0.0, 0.0}) {
    const glm::dvec3 ankle = figure.pose.place(leg.end);
    const glm::dvec3 ball = leg.tip < 0 ? ankle : figure.pose.place(leg.tip);
    const glm::dquat to_foot = glm::conjugate(figure.pose.rotation(leg.end));
    const glm::dvec3 way = glm::conjugate(held) * (ball - ankle);
    const bool stands = ankle.y - figure.ground < figure.ankle + raised * figure.leg;
    const double down = stands ? figure.ground - ankle.y : -figure.ankle;
    return {to_foot * (held * glm::dvec3(0.0, down, 0.0)), to_foot * (held * glm::dvec3(way.x, down, way.z))};
  }

  /// Returns how far a hip joint is beside the middle of both.
  static glm::dvec3 beside_middle(const Figure& figure, const LimbBones& leg) {
    if (!has_hip_joints(figure)) return glm::dvec3(0.0);
    const glm::dvec3 beside = figure.pose.place(leg.upper) - hip_joints(figure);
    return {beside.x, 0.0, beside.z};
  }

  void plan_leg(const LimbBones& own, const LimbBones& source) {
    if (source_of(own.upper) != source.upper || source_of(own.middle) != source.middle) return;
    if (source_of(own.end) != source.end) return;
    FollowedLeg leg{
        .own = own, .source = source, .own_sole = sole_of(own_, own), .source_sole = {}, .shin = {}, .wider = {}};
    const glm::dquat held = glm::conjugate(plan_.turn) * foot_held(own, source) * plan_.turn;
    leg.source_sole = sole_of(source_, source, held);
    leg.shin = in_parent(own_.pose, own.end, own.middle);
    leg.own_foot = own_.pose.rotation(own.end);
    leg.wider = beside_middle(own_, own) - plan_.turn * (plan_.scale * beside_middle(source_, source));
    if (!source_stands_) leg.source_sole = flat_sole(own, source);
    plan_.legs.push_back(leg);
  }

  const RigMatch& match_;
  Figure source_;
  Figure own_;
  bool has_same_frames_ = false;
  bool source_stands_ = true;  ///< in its reference pose; else that shows neither its soles nor its ground
  RetargetPlan plan_;
};

}  // namespace

RetargetPlan plan_retarget(const Skeleton& from, const Skeleton& to, const RigMatch& match) {
  return Planner(from, to, match).plan();
}

}  // namespace throng::anim
