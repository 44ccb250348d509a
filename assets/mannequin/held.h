#pragma once

#include "assets/mannequin/reach.h"

namespace throng::mannequin {

/// The middle of a phone in the left hand at rest, from its wrist; it lies along the palm.
glm::dvec3 phone_in_hand();
/// Closes the right hand's fingers around a phone.
void grip_phone(Pose& pose, double phase);
/// Holds a phone before the chest with the right hand, its glass to the eyes.
void hold_phone(Pose& pose, double phase);

/// The middle of a handle or a shaft in the left fist at rest, from its wrist; it lies across the palm.
glm::dvec3 handle_in_hand();

/// The middle of a cup in the left hand at rest, from its wrist; its axis runs to the thumb's side.
glm::dvec3 cup_in_hand();

/// Returns how a hand that holds a camera is turned: `out` is the way to the hand's side, `facing` to the face.
glm::dquat hand_at_camera(Side side, glm::dvec3 out, glm::dvec3 facing, glm::dvec3 upwards);
inline constexpr double hand_from_camera = 0.050;  ///< Metres from its middle to what a hand holds.
glm::dvec3 camera_in_hand();

inline constexpr double stick_length = 0.87;  ///< Metres from the handle of a walking stick to its tip.
inline constexpr double bar_height = 1.03;    ///< Of a pushchair's bar above the ground.
inline constexpr double bar_ahead = 0.40;     ///< Of it before the root.

}  // namespace throng::mannequin
