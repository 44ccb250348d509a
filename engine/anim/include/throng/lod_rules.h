#pragma once

#include "throng/standard.h"

namespace throng {

inline constexpr int longest_interval = 16;  ///< frames
inline constexpr int max_bone_levels = 4;    ///< of a character (paper 3.2); level 0 has all bones

enum class LodRule : unsigned char {
  off,       ///< every agent, seen or not, is posed every frame
  distance,  ///< the farther from the camera, the longer the interval between updates
  budget     ///< the cheapest choice whose predicted error on screen is within the limits
};

/// The settings of the rules. A change takes effect for each agent at its next update. Distances are from the camera to
/// the centre of the agent's bounds. An agent exactly at a distance counts as beyond it.
struct LodRules {
  LodRule rule = LodRule::budget;
  float error_pixels = 1.0F;  ///< budget: 99% of shown errors of poses stay below it; 0: no limit
  double budget_milliseconds =
      0.0;  ///< budget: of all PUs, a frame; agents that come into view are exempt; 0: no limit
  float full_rate_distance = 12.0F;  ///< distance: metres up to which agents are posed every frame
  float interval_growth = 12.0F;     ///< distance: metres for each further frame of the interval
  int largest_interval = 8;          ///< frames, 1 to longest_interval
  bool bone_lod = true;              ///< fewer bones far off
  bool smooth = false;               ///< the renderer blends each palette from the last one over its look-ahead
  std::array<float, max_bone_levels - 1> level_distances{15.0F, 30.0F,
                                                         60.0F};  ///< distance: metres from which levels 1 to 3 begin
  float centre_importance = 1.25F;  ///< budget: the error counts so many times within centre_degrees of the middle
  float centre_degrees = 8.0F;

  friend bool operator==(const LodRules&, const LodRules&) = default;
};

/// Overrules the rule, to show an interval or a level. Takes effect at an agent's next update.
struct LodForce {
  int interval = 0;     ///< frames, 1 to longest_interval; 0: the rule decides
  int bone_level = -1;  ///< a higher level than the character's last means the last; -1: the rule decides
  std::optional<std::uint32_t> agent = {};  ///< this agent alone; nothing: all agents

  [[nodiscard]] bool concerns(std::size_t other) const { return !agent || *agent == other; }
  friend bool operator==(const LodForce&, const LodForce&) = default;
};

}  // namespace throng
