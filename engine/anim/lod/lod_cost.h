#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace throng::anim {

/// Tolerances are told apart in eighths of an octave, from an eighth of a pixel to 56 pixels.
inline constexpr int steps_an_octave = 8;
inline constexpr int tolerance_steps = 72;
inline constexpr float least_tolerance_pixels = 0.125F;

inline float tolerance_at(float step) { return least_tolerance_pixels * std::exp2(step / steps_an_octave); }
inline float step_of_tolerance(float pixels) { return steps_an_octave * std::log2(pixels / least_tolerance_pixels); }
inline const float most_tolerance_pixels = tolerance_at(tolerance_steps - 1);

/// [step]: nanoseconds a frame that those in view would cost in the long run at that tolerance; descending.
using CostByTolerance = std::array<std::uint64_t, tolerance_steps>;

/// What one frame costs by the cost model, nanoseconds of one PU, and what it would have.
struct LodCost {
  std::uint64_t everyone = 0;       ///< each agent posed with all bones, seen or not
  std::uint64_t visible = 0;        ///< those in view, each posed with all bones
  std::uint64_t due_all_bones = 0;  ///< those in view whose turn it is, with all bones
  std::uint64_t due = 0;            ///< those in view whose turn it is, as they are posed
  std::uint64_t reappeared = 0;     ///< of `due`, the first two updates of who comes into view: exempt from any budget
  CostByTolerance by_tolerance{};   ///< counted if LodRules::counts_cost; else 0

  LodCost& operator+=(const LodCost& other) {
    everyone += other.everyone;
    visible += other.visible;
    due_all_bones += other.due_all_bones;
    due += other.due;
    reappeared += other.reappeared;
    for (std::size_t step = 0; step < by_tolerance.size(); ++step) by_tolerance[step] += other.by_tolerance[step];
    return *this;
  }
};

}  // namespace throng::anim
