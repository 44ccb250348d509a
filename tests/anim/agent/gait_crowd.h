#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/anim/agent/animation_system.h"

namespace throng::anim {

/// The clips of the character below. The strikes of feet of `walk` and `jog` lie at different phases.
namespace gaits {
inline constexpr int idle = 0;    ///< breathes
inline constexpr int walk = 1;    ///< 1.4 m/s; left at 0.1 s, right at 0.5 s
inline constexpr int jog = 2;     ///< 2.6 m/s; right at 0.2 s, left at 0.8 s
inline constexpr int run = 3;     ///< 4.2 m/s; left at 0.05 s, right at 0.6 s
inline constexpr int aside = 4;   ///< 1.4 m/s towards +X; left at 0.1 s, right at 0.5 s
inline constexpr int gallop = 5;  ///< 3 m/s; left, left, right
inline constexpr int wave = 6;    ///< has the key "hit" at 0.3 s
inline constexpr int bend = 7;    ///< walks at 1.4 m/s and turns left by a quarter a second
inline constexpr double walk_speed = 1.4;
inline constexpr double jog_speed = 2.6;
inline constexpr double run_speed = 4.2;
}  // namespace gaits

/// Returns a synthetic character of 20 bones that has these clips, whose lengths differ.
std::shared_ptr<const Character> gait_character();

/// One agent of that character, at 60 frames a second.
struct GaitCrowd {
  explicit GaitCrowd(std::uint32_t agents = 1);

  AnimationSystem* operator->() const { return system.get(); }
  Ticks step(Ticks by = ticks_per_second / 60);  ///< advances, updates agent 0, and returns the clock before
  /// Returns the players that agent 0 plays, in the order of its program.
  std::vector<const Player*> players() const;
  const Player* player_of(int clip) const;  ///< null: it does not play
  std::vector<DataKeyEvent> keys(Ticks from, KeyChoice choice = KeyChoice::felt) const;
  const std::string& name(const DataKeyEvent& event) const;

  std::unique_ptr<AnimationSystem> system;
};

/// Returns the phase of a player in its clip, 0 to below 1.
double phase(const Player& player);

}  // namespace throng::anim
