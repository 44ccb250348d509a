#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include <glm/vec3.hpp>

#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"
#include "assets/mannequin/pose.h"

namespace throng::mannequin {

/// A gait. Phases count from the left foot's strike; angles are degrees, lengths metres. Who walks back has a speed, a
/// turn of pelvis and chest, and a swing of the arms below zero: the same limbs are ahead when the other foot is.
struct Gait {
  std::size_t frames;
  double speed;        ///< Metres a second ahead; below zero back.
  double aside = 0;    ///< Metres a second to the left; below zero to the right.
  double stance;       ///< Share of the cycle that a foot is on the ground.
  double foot_flat;    ///< Where the planted ankle lies ahead of the hips in the middle of the stance.
  double foot_spread;  ///< Of the ankles from the centre line.
  double toe_out;
  std::array<CurveKey, 7> pitch;    ///< Of the foot, toes up; zero while it is flat.
  double swing_height;              ///< Of the ankle above the straight way, early in the swing.
  double peel = 0.19, drop = 0.30;  ///< How steeply a foot leaves and comes down: up and down, per metre of ground.
  double crouch;                    ///< Of the hips below rest, mean.
  double bounce, bounce_peak;       ///< Of the hips, twice per cycle.
  double sway;                      ///< Of the hips towards the standing leg.
  double pelvis_turn, pelvis_drop;
  double chest_turn;  ///< Against the pelvis.
  double lean;        ///< Of the trunk.
  double arm_swing, arm_forward, arm_spread;
  double elbow, elbow_swing;
  double curl;  ///< Of the fingers.
};

const Gait& walking();

/// The whole body at a phase of a gait, the root at the origin.
Pose stride_pose(const Gait& gait, double phase);
ArmAngles swinging_arm(const Gait& gait, double phase);
/// Bends one leg so that its foot is where the gait has it at `phase`, wherever the hips of the pose are.
void step(Pose& pose, const Gait& gait, Side side, double phase);
glm::dvec3 stride(const Gait& gait);  ///< Metres that the root goes in a cycle.

/// A looping clip of a gait, which marks where its feet come down. `pose` is given the gait's phase.
Motion gait_clip(const char* name, const Gait& gait, const std::function<Pose(const Gait& gait, double phase)>& pose);

/// Clips begin where the left foot stands and the right one swings through, where everything moves smoothly.
inline constexpr double first_phase = 0.25;

}  // namespace throng::mannequin
