#include "engine/anim/bake/body_turn.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/anim/bake/surface.h"
#include "engine/anim/base/elementary.h"

namespace throng::anim {

namespace {

using Frames = std::vector<BoneFrame>;

// Metres are for a person of 1.8 m.
constexpr double degree = std::numbers::pi / 180.0;
constexpr double closed = 0.005;
constexpr double near_enough = 0.03;
constexpr double nearer = 0.5;  // of the distance of before
constexpr double most_turn = 270.0 * degree;
constexpr double least_turn = 20.0 * degree, least_closed_turn = 3.0 * degree;
constexpr double least_climb = 0.10, least_closed_climb = 0.05;

/// The poses of a clip at even steps, closely enough that no body turns by half a turn in between.
struct Survey {
  std::vector<Frames> frames;
  double seconds = 0.0;

  const Frames& first() const { return frames.front(); }
  const Frames& last() const { return frames.back(); }
};

Survey survey(const Skeleton& skeleton, const StateClip& clip) {
  const AlignedBytes block = pack_keyframe_stream(clip);
  ExactPoses poses(*reinterpret_cast<const KeyframeStream*>(block.get()));
  Survey survey{.frames = {}, .seconds = to_seconds(clip.duration)};
  const auto steps = static_cast<std::int64_t>(std::clamp(survey.seconds * 30.0, 16.0, 1800.0));
  for (std::int64_t i = 0; i <= steps; ++i) {
    Frames& frames = survey.frames.emplace_back(skeleton.bones.size());
    compute_frames(skeleton, poses.at(clip.duration * i / steps), frames);
  }
  return survey;
}

double turn_about_up(const glm::dmat3& from, const glm::dmat3& to) {
  const glm::dmat3 turn = to * glm::inverse(from);
  const glm::dquat q = glm::normalize(glm::quat_cast(turn / cube_root(glm::determinant(turn))));
  return 2.0 * arc_tangent(q.y, q.w);
}

/// Returns the turn from the first pose to the last, with the whole turns in between.
double whole_turn(const Survey& survey, int bone) {
  constexpr double round = 2.0 * std::numbers::pi;
  const auto axes = [&](const Frames& frames) { return frames[static_cast<std::size_t>(bone)].axes; };
  double sum = 0.0;
  for (std::size_t i = 1; i < survey.frames.size(); ++i) {
    sum += std::remainder(turn_about_up(axes(survey.frames[i - 1]), axes(survey.frames[i])), round);
  }
  const double turn = turn_about_up(axes(survey.first()), axes(survey.last()));
  return turn + round * std::round((sum - turn) / round);
}

/// The joints that a bone carries, itself among them.
std::vector<std::size_t> joints_below(const Skeleton& skeleton, int bone) {
  std::vector<bool> below(skeleton.bones.size(), false);
  std::vector<std::size_t> joints;
  for (std::size_t i = static_cast<std::size_t>(bone); i < below.size(); ++i) {
    const int parent = skeleton.bones[i].parent;
    below[i] = static_cast<int>(i) == bone || (parent >= 0 && below[static_cast<std::size_t>(parent)]);
    if (below[i]) joints.push_back(i);
  }
  return joints;
}

/// How far joints are from where they should be, before and after a motion is taken out.
struct Closing {
  bool all_near = true;
  double farthest = 0.0;
  bool accepts(double amount, double least, double least_closed, double size) const {
    return std::abs(amount) >= (farthest <= closed * size ? least_closed : least) &&
           (all_near || farthest <= closed * size);
  }
};

Closing closing(std::span<const std::size_t> joints, double size, const std::function<double(std::size_t)>& before,
                const std::function<double(std::size_t)>& after) {
  Closing result;
  for (const std::size_t joint : joints) {
    const double now = after(joint);
    result.farthest = std::max(result.farthest, now);
    result.all_near = result.all_near && now <= std::max(nearer * before(joint), near_enough * size);
  }
  return result;
}

double on_ground(const glm::dvec3& v) { return glm::length(glm::dvec2(v.x, v.z)); }

/// Returns the turn that the last pose has to the first, as `turning` says it; 0 if the body does not turn with it.
double turn_of_body(const Survey& survey, std::span<const std::size_t> joints, std::size_t pivot, int turning,
                    double size) {
  const double yaw = whole_turn(survey, turning);
  if (std::abs(yaw) > most_turn) return 0.0;
  const RootMotion turn{.yaw = yaw};
  const auto from_pivot = [&](const Frames& frames, std::size_t joint) {
    return frames[joint].origin - frames[pivot].origin;
  };
  const auto moved = [&](std::size_t joint) {
    return on_ground(from_pivot(survey.last(), joint) - from_pivot(survey.first(), joint));
  };
  const auto left = [&](std::size_t joint) {
    const RootMotion turned = compose(turn, {.translation = from_pivot(survey.first(), joint)});
    return on_ground(from_pivot(survey.last(), joint) - turned.translation);
  };
  const bool turns = closing(joints, size, moved, left).accepts(yaw, least_turn, least_closed_turn, size);
  return turns ? yaw : 0.0;
}

double climb_of_body(const Survey& survey, std::span<const std::size_t> joints, std::size_t pivot, double size) {
  const auto rise = [&](std::size_t joint) { return survey.last()[joint].origin.y - survey.first()[joint].origin.y; };
  const double climb = rise(pivot);
  const auto moved = [&](std::size_t joint) { return std::abs(rise(joint)); };
  const auto left = [&](std::size_t joint) { return std::abs(rise(joint) - climb); };
  const Closing closes = closing(joints, size, moved, left);
  return closes.accepts(climb, least_climb * size, least_closed_climb * size, size) ? climb : 0.0;
}

RootVelocity turning_velocity(const Survey& survey, std::size_t pivot, double yaw) {
  const RootMotion turned = compose({.yaw = yaw}, {.translation = survey.first()[pivot].origin});
  glm::dvec3 travel = survey.last()[pivot].origin - turned.translation;
  travel.y = 0.0;
  return steady_velocity({.translation = travel, .yaw = yaw}, survey.seconds);
}

}  // namespace

RootVelocity steady_root_velocity(const Skeleton& skeleton, const StateClip& clip, int bone, const glm::dvec3& travel,
                                  double size) {
  const Survey poses = survey(skeleton, clip);
  const auto pivot = static_cast<std::size_t>(bone);
  const std::vector<std::size_t> joints = joints_below(skeleton, bone);
  double yaw = 0.0;
  for (std::size_t i = 0; i < joints.size() && yaw == 0.0; ++i) {
    const auto turning = static_cast<int>(joints[i]);
    if (2 * joints_below(skeleton, turning).size() <= skeleton.bones.size()) continue;
    yaw = turn_of_body(poses, joints, pivot, turning, size);
  }
  const RootVelocity straight{.linear = travel / poses.seconds};
  RootVelocity velocity = yaw == 0.0 ? straight : turning_velocity(poses, pivot, yaw);
  velocity.linear.y = climb_of_body(poses, joints, pivot, size) / poses.seconds;
  return velocity;
}

}  // namespace throng::anim
