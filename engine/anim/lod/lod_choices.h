#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/lod/lod.h"
#include "engine/anim/lod/lod_cost.h"

namespace throng::anim {

/// A way to update an agent.
struct LodChoice {
  std::uint8_t interval = 1;    ///< frames
  std::uint8_t bone_level = 0;  ///< 0: all bones

  friend bool operator==(const LodChoice&, const LodChoice&) = default;
};

/// An allowance is an error that may be shown. Its steps are eighths of an octave, from 2^-14 m to 2^5 m.
inline constexpr int allowance_steps = 19 * steps_an_octave;
inline constexpr float least_allowance_metres = 0x1p-14F;

/// Returns the largest step whose error is at most `metres`; below 0 where even the least step is larger.
int allowance_step(float metres);

/// All choices of level of detail for one clip of one character: the error and the cost of each pair of interval and
/// bone level, and the cheapest pair for each allowance. The errors of interval and level are added.
class MotionLod {
 public:
  MotionLod(const LodCharacter& character, const SkipError& motion, const LodRules& rules, float frame_seconds);

  /// Returns the cheapest pair within `metres` of error. The second form keeps the shown pair while it is within
  /// `metres` and no cheaper pair is within nine tenths of it, so that no agent flickers between two pairs.
  LodChoice choose(float metres) const { return choice_[clamped(allowance_step(metres))]; }
  LodChoice choose(float metres, LodChoice shown) const;

  float error_metres(LodChoice choice) const { return error_[choice.bone_level][choice.interval - 1U]; }
  /// Returns nanoseconds a frame.
  float cost(LodChoice choice) const {
    const std::uint32_t more = choice == LodChoice{} ? full_rate_cost_ : 0;
    return static_cast<float>(update_cost_[choice.bone_level] + more) / static_cast<float>(choice.interval);
  }
  /// Returns nanoseconds of one update.
  std::uint32_t update_cost(std::size_t bone_level) const { return update_cost_[bone_level]; }

  /// Adds to each tolerance the cost of the agent at it. One pixel allows the agent `metres_a_pixel` of error.
  void add_cost(float metres_a_pixel, std::span<std::uint32_t, tolerance_steps> by_tolerance) const;

 private:
  struct Pair {
    LodChoice choice;
    float cost, error;
  };
  static std::size_t clamped(int step);
  std::vector<Pair> cheapest_first(int levels, int intervals) const;

  std::array<std::uint32_t, allowance_steps> cost_{};  // nanoseconds a frame
  std::array<LodChoice, allowance_steps> choice_{};
  std::array<std::array<float, longest_interval>, max_bone_levels> error_{};  // metres
  std::array<std::uint32_t, max_bone_levels> update_cost_{};                  // nanoseconds
  std::uint32_t full_rate_cost_ = 0;  // nanoseconds on top, with all bones in every frame
};

/// Holds the MotionLod of every clip of all characters.
class LodChoices {
 public:
  /// Call it at load time, and when the rules or the length of a frame have changed. Allocates.
  void build(std::span<const LodCharacter> characters, const LodRules& rules, float frame_seconds);

  bool empty() const { return motions_.empty(); }

  /// Returns the motion of an agent that goes over from any clip to another.
  const MotionLod& changing(std::size_t character) const { return motions_[first_[character]]; }

  /// Returns the motion of a clip; `clip` below 0 means standing still.
  const MotionLod& of(std::size_t character, int clip) const {
    const std::size_t first = first_[character] + 1, motions = first_[character + 1] - first;
    const int motion = clip + 1;
    const auto index = static_cast<std::size_t>(motion);
    return motions_[first + (index < motions ? index : motions - 1)];
  }

 private:
  std::vector<MotionLod> motions_;
  std::vector<std::size_t> first_;  // [characters + 1] changing, standing still, then clips
};

}  // namespace throng::anim
