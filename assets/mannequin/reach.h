#pragma once

#include <string_view>

#include "assets/mannequin/pose.h"

namespace throng::mannequin {

/// Says where and how a hand shall hold something.
struct HandTarget {
  glm::dvec3 grip;      ///< World position of what it holds.
  glm::dquat rotation;  ///< Of the hand from its rest, in the world.
  glm::dvec3 held;      ///< What it holds, from the wrist of the left hand at rest.
  glm::dvec3 elbow{0};  ///< World direction in which the elbow points.
};

/// A place in the left hand at rest, from its wrist: along the fingers, towards the thumb, and out of the palm.
glm::dvec3 in_hand(double along, double thumb, double palm);
inline constexpr double palm_along = 0.083;  ///< Metres from the wrist to where fingers close around something.

/// Returns how a hand is turned whose palm faces one way and whose fingers point as near to another as that allows.
glm::dquat palm_towards(Side side, glm::dvec3 palm, glm::dvec3 fingers);
/// The same whose fingers point one way, and whose palm faces as near to another as that allows.
glm::dquat fingers_towards(Side side, glm::dvec3 fingers, glm::dvec3 palm);
/// The same of a fist whose thumb's side points one way, and whose palm faces as near to another as that allows.
glm::dquat thumb_towards(Side side, glm::dvec3 thumb, glm::dvec3 palm);

/// Between two targets; `share` runs from 0 to 1.
HandTarget mix(const HandTarget& from, const HandTarget& to, double share);

/// Bends shoulder, elbow and wrist so that the hand is at its target. The collar bone stays as it is. Returns by how
/// many metres the arm is too short.
double place_hand(Pose& pose, Side side, const HandTarget& target);

/// A body part as it is posed, which carries along what is given by its place and direction at rest.
class Carried {
 public:
  Carried(const Pose& pose, std::string_view joint);
  [[nodiscard]] glm::dvec3 place(glm::dvec3 at_rest) const {
    return posed_.position + posed_.rotation * (at_rest - rest_);
  }
  [[nodiscard]] glm::dvec3 way(glm::dvec3 at_rest) const { return posed_.rotation * at_rest; }

 private:
  WorldJoint posed_;
  glm::dvec3 rest_;
};

}  // namespace throng::mannequin
