#include "engine/anim/retarget/figure.h"

#include <algorithm>
#include <array>
#include <span>

#include <glm/geometric.hpp>

namespace throng::anim {
namespace {

/// Returns a leg that was found, or the leg that the bones' parts say: a file that rests in the middle of a clip may
/// have its legs anywhere.
std::optional<LimbBones> leg_of(const std::optional<LimbBones>& found, const RigMap& rig,
                                const std::array<BodyRole, 4>& parts) {
  const LimbBones said{
      .upper = rig.at(parts[0]), .middle = rig.at(parts[1]), .end = rig.at(parts[2]), .tip = rig.at(parts[3])};
  if (found || said.upper < 0 || said.middle < 0 || said.end < 0) return found;
  return said;
}

double bones_of_leg(const BodyPose& pose, const LimbBones& leg) {
  return glm::distance(pose.place(leg.upper), pose.place(leg.middle)) +
         glm::distance(pose.place(leg.middle), pose.place(leg.end));
}

/// The ground is at height 0, as files have it, unless the feet show that the origin is elsewhere, as at the hips.
double ground_of(const Figure& figure) {
  constexpr double above = 0.45, below = 0.05;  // of the leg's bones, for ankles
  const BodyPose& pose = figure.pose;
  std::vector<const LimbBones*> legs = legs_of(figure);
  if (legs.empty()) return 0.0;
  std::ranges::stable_sort(legs, {}, [&](const LimbBones* leg) { return pose.place(leg->end).y; });
  const double ankle = pose.place(legs.front()->end).y, length = bones_of_leg(pose, *legs.front());
  const bool is_upright = pose.place(legs.front()->upper).y - ankle > 0.5 * length;
  if (!is_upright) return 0.0;  // a handstand shows no ground
  const bool stands = ankle > -below * length && ankle < above * length;
  if (stands) return 0.0;
  const int ball = legs.front()->tip;
  return std::min(ankle - 0.1 * length, ball < 0 ? ankle : pose.place(ball).y - 0.02 * length);
}

/// Returns the mean height of ankles that are as high as each other, or the height of the lower ankle, which stands.
double standing_height(std::span<const double> ankles, double most_apart) {
  const auto [low, high] = std::ranges::minmax(ankles);
  return high - low > most_apart ? low : (low + high) / 2.0;
}

}  // namespace

std::vector<const LimbBones*> legs_of(const Figure& figure) {
  std::vector<const LimbBones*> legs;
  if (figure.left_leg) legs.push_back(&*figure.left_leg);
  if (figure.right_leg) legs.push_back(&*figure.right_leg);
  return legs;
}

Carriage carriage_of(const Figure& figure) {
  constexpr double most_upright = -0.9, least_bent = -0.6;  // cosines of 154 and 127 degrees; a fox has 103
  const auto middle = [&](BodyRole left, BodyRole right) {
    return 0.5 * (figure.pose.place(figure.rig.at(left)) + figure.pose.place(figure.rig.at(right)));
  };
  for (const BodyRole role : {BodyRole::left_upper_arm, BodyRole::right_upper_arm, BodyRole::left_upper_leg,
                              BodyRole::right_upper_leg, BodyRole::left_foot, BodyRole::right_foot}) {
    if (figure.rig.at(role) < 0) return Carriage::unknown;
  }
  const glm::dvec3 hips = middle(BodyRole::left_upper_leg, BodyRole::right_upper_leg);
  const glm::dvec3 trunk = middle(BodyRole::left_upper_arm, BodyRole::right_upper_arm) - hips;
  const glm::dvec3 legs = middle(BodyRole::left_foot, BodyRole::right_foot) - hips;
  const double lengths = glm::length(trunk) * glm::length(legs), cosine = glm::dot(trunk, legs);
  if (!(lengths > 0.0)) return Carriage::unknown;
  if (cosine < most_upright * lengths) return Carriage::upright;
  return cosine > least_bent * lengths ? Carriage::bent : Carriage::unknown;
}

Figure figure_of(const Skeleton& skeleton, const RigMap& rig) {
  Figure figure{.skeleton = skeleton, .rig = rig, .pose = bind_pose(skeleton)};
  figure.left_leg =
      leg_of(rig.limbs.left_leg, rig,
             {BodyRole::left_upper_leg, BodyRole::left_lower_leg, BodyRole::left_foot, BodyRole::left_toes});
  figure.right_leg =
      leg_of(rig.limbs.right_leg, rig,
             {BodyRole::right_upper_leg, BodyRole::right_lower_leg, BodyRole::right_foot, BodyRole::right_toes});
  figure.ground = ground_of(figure);
  const std::vector<const LimbBones*> legs = legs_of(figure);
  std::vector<double> ankles;
  for (const LimbBones* leg : legs) {
    figure.leg += bones_of_leg(figure.pose, *leg) / static_cast<double>(legs.size());
    ankles.push_back(std::max(0.0, figure.pose.place(leg->end).y - figure.ground));
  }
  if (!ankles.empty()) figure.ankle = standing_height(ankles, raised * figure.leg);
  return figure;
}

}  // namespace throng::anim
