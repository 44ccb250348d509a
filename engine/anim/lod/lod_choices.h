#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/lod/lod.h"
#include "engine/anim/lod/lod_cost.h"

namespace throng::anim {

/// How an agent is updated.
struct LodChoice {
  std::uint8_t interval = 1;    ///< frames
  std::uint8_t bone_level = 0;  ///< 0: all bones

  friend bool operator==(const LodChoice&, const LodChoice&) = default;
};

/// Errors that may be allowed are told apart in eighths of an octave, from 2^-14 m to 2^5 m.
inline constexpr int allowance_steps = 19 * steps_an_octave;
inline constexpr float least_allowance_metres = 0x1p-14F;

/// The largest step whose error is at most `metres`; below 0 where even the least is more.
int allowance_step(float metres);

/// Everything that level of detail can choose for one clip of one character: what each pair of interval and bone level
/// costs in error and in time, and the cheapest for each error that may be allowed. Errors of the two are added.
class MotionLod {
 public:
  MotionLod(const LodCharacter& character, const SkipError& motion, const LodRules& rules, float frame_seconds);

  /// Within `metres` of error. The pair shown now stays while it is within them and nothing cheaper is within nine
  /// tenths of them, so that nobody flickers between two.
  LodChoice choose(float metres) const { return choice_[clamped(allowance_step(metres))]; }
  LodChoice choose(float metres, LodChoice shown) const;

  float error_metres(LodChoice choice) const { return error_[choice.bone_level][choice.interval - 1U]; }
  /// Nanoseconds a frame.
  float cost(LodChoice choice) const {
    const std::uint32_t more = choice == LodChoice{} ? full_rate_cost_ : 0;
    return static_cast<float>(update_cost_[choice.bone_level] + more) / static_cast<float>(choice.interval);
  }
  /// Nanoseconds when its turn comes.
  std::uint32_t update_cost(std::size_t bone_level) const { return update_cost_[bone_level]; }

  /// Adds to each tolerance what the agent costs at it; `metres_a_pixel` is the error that a pixel allows it.
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
  std::uint32_t full_rate_cost_ = 0;                                          // nanoseconds, on top
};

/// The motions of all characters.
class LodChoices {
 public:
  /// At load time, and when rules or the length of a frame have changed; allocates.
  void build(std::span<const LodCharacter> characters, const LodRules& rules, float frame_seconds);

  bool empty() const { return motions_.empty(); }

  /// Of one who goes over from one clip to another, whichever they are.
  const MotionLod& changing(std::size_t character) const { return motions_[first_[character]]; }

  /// `clip` below 0: standing still.
  const MotionLod& of(std::size_t character, int clip) const {
    const std::size_t first = first_[character] + 1, motions = first_[character + 1] - first;
    const int motion = clip + 1;
    const auto index = static_cast<std::size_t>(motion);
    return motions_[first + (index < motions ? index : motions - 1)];
  }

 private:
  std::vector<MotionLod> motions_;
  std::vector<std::size_t> first_;  // [character], and the end: changing, standing still, then its clips
};

}  // namespace throng::anim
