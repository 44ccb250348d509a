#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "assets/mannequin/pose.h"

namespace throng::mannequin {

inline constexpr double key_rate = 30.0;  ///< Keys per second; every duration is a multiple of its inverse.
inline constexpr double rotation_step = 1.0 / (1 << 20);  ///< Of quaternion components as written.
inline constexpr double offset_step = 1.0 / (1 << 18);    ///< Metres, of translations as written.
inline constexpr double mark_step = 1.0 / (1 << 10);      ///< Seconds, of marks as written.

/// A moment that whoever plays the clip may want to know of: a foot comes to the ground.
struct Mark {
  double phase;  ///< 0 to 1
  std::string name;
};

/// A movement as it is authored: a pose for every phase from 0 to 1, the root's way included.
struct Motion {
  std::string name;
  std::size_t frames;  ///< of 1 / key_rate seconds
  bool loops;          ///< The pose of phase 1 is that of phase 0 but for the root.
  std::function<Pose(double phase)> pose;
  std::vector<Mark> marks = {};

  [[nodiscard]] double seconds() const { return static_cast<double>(frames) / key_rate; }
};

/// A motion as it is written: one pose per key. Of a loop the last is the first, to the bit, but for the root.
struct Clip {
  std::string name;
  std::vector<Pose> keys;
  std::vector<Mark> marks;
};
Clip sample(const Motion& motion);

/// All motions in the order in which the file lists them, and their clips.
std::vector<Motion> make_motions();
std::vector<Clip> make_clips();

Motion make_idle();
Motion make_look_around();
Motion make_talk();
Motion make_walk();
Motion make_jog();
Motion make_run();
Motion make_walk_back();
Motion make_shuffle();
Motion make_step_in_place();
Motion make_side_step(Side towards);
Motion make_veer(Side towards);
Motion make_stumble();
Motion make_turn(Side towards);
Motion make_cheer();
Motion make_wave();
Motion make_clap();
Motion make_sit_down();
Motion make_sit();
Motion make_stand_up();
Motion make_phone();
Motion make_call();
Motion make_drink();
Motion make_take_picture();
Motion make_lean();
Motion make_sit_on_step();

// These clips are for an arm while the rest of the body does something else. Its joints alone play them.
Motion make_carry();
Motion make_hold_up();
Motion make_hold_phone();
Motion make_lead();
Motion make_led();
Motion make_push();
Motion make_stick();

}  // namespace throng::mannequin
