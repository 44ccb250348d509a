#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace throng::anim {

/// The steps of tolerances, which are eighths of an octave from an eighth of a pixel to 58.7 pixels.
inline constexpr int steps_an_octave = 8;
inline constexpr int tolerance_steps = 72;
inline constexpr float least_tolerance_pixels = 0.125F;

inline float tolerance_at(float step) { return least_tolerance_pixels * std::exp2(step / steps_an_octave); }
inline float step_of_tolerance(float pixels) { return steps_an_octave * std::log2(pixels / least_tolerance_pixels); }
inline const float most_tolerance_pixels = tolerance_at(tolerance_steps - 1);

/// The nanoseconds a frame, [step], that agents in view would cost in the long run at each tolerance. They descend.
using CostByTolerance = std::array<std::uint64_t, tolerance_steps>;

/// The cost of one frame by the cost model, in nanoseconds of one PU, and the cost of other choices.
struct LodCost {
  std::uint64_t everyone = 0;       ///< all agents, seen or not, with all bones
  std::uint64_t visible = 0;        ///< agents in view, with all bones
  std::uint64_t due_all_bones = 0;  ///< agents in view whose turn it is, with all bones
  std::uint64_t due = 0;            ///< agents in view whose turn it is, as they are posed
  std::uint64_t reappeared = 0;     ///< the first two updates of agents that come into view; exempt from any budget
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
