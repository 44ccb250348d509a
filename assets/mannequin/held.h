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

inline constexpr double stick_length = 0.87;  ///< Metres from the handle of a walking stick to its tip.
inline constexpr double bar_height = 1.03;    ///< Of a pushchair's bar above the ground.
inline constexpr double bar_ahead = 0.40;     ///< Of it before the root.

}  // namespace throng::mannequin
