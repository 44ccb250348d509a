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

/// A looping clip: one pose per key, the last the same as the first but for the root's way.
struct Clip {
  std::string name;
  std::vector<Pose> keys;
};

/// Samples a motion over one cycle, phase in [0, 1]; the root moves evenly along +Z at `speed` metres per second.
Clip sample_loop(std::string name, std::size_t frames, double speed, const std::function<Pose(double phase)>& motion);

/// All clips in the order in which the file lists them.
std::vector<Clip> make_clips();

Clip make_idle();
Clip make_walk();
Clip make_jog();
Clip make_run();
Clip make_cheer();
Clip make_wave();
Clip make_clap();

}  // namespace throng::mannequin
