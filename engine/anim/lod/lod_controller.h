#pragma once

#include <cstdint>
#include <optional>

#include "throng/lod_rules.h"

#include "engine/anim/lod/lod_cost.h"

namespace throng::anim {

inline constexpr double nanoseconds_per_millisecond = 1e6;
/// Returns LodRules::budget_milliseconds in nanoseconds; 0: no limit.
inline double budget_nanoseconds(const LodRules& rules) {
  return rules.budget_milliseconds * nanoseconds_per_millisecond;
}

enum class BindingLimit : std::uint8_t {
  none,       ///< the finest choices fit the budget
  error,      ///< a larger error would save time
  budget,     ///< more time would lower the error; the limit on the error gives way
  both_miss,  ///< both limits are set, and even the coarsest choices do not fit the budget
};

/// Returns "none", "error", "budget" or "both miss".
const char* name_of(BindingLimit limit);

/// The outcome of the last frame.
struct LodOutcome {
  CostByTolerance cost_by_tolerance{};
  double nanoseconds = 0.0;                         ///< predicted, for all posed agents that are not exempt
  double exempt_nanoseconds = 0.0;                  ///< predicted, for agents that came into view
  std::optional<float> measured_error_pixels = {};  ///< p99 over the last frames; none: too little was measured
};

/// Sets LodFrame::tolerance_pixels, frame by frame, so that the limits of the rules hold. It depends on outcomes alone,
/// so a replay decides alike.
///
/// It learns slowly, for the limit on the error, the ratio of tolerance to error at which the measured error stays
/// below the limit. It takes, for the budget, the least tolerance at which the predicted cost fits. The tolerance rises
/// to it in one step and sinks to it slowly; within a band in between it stays. The larger tolerance counts.
class LodController {
 public:
  /// Forgets all that was learned. Call it before the first frame, and when the crowd starts again.
  void reset(const LodRules& rules);

  /// Returns true until begin() or settle() is called.
  bool is_new() const { return is_new_; }
  /// Finds a tolerance for a budget before the first frame, from the cost of the agents in view.
  void begin(const LodRules& rules, const CostByTolerance& cost);

  void settle(const LodRules& rules, const LodOutcome& outcome);

  float tolerance_pixels() const { return tolerance_; }
  BindingLimit binding() const { return binding_; }

 private:
  void learn_error_factor(float wanted, float measured);
  void learn_headroom(const LodOutcome& outcome);
  float budget_tolerance(const CostByTolerance& cost, double nanoseconds) const;

  float tolerance_ = 1.0F;
  float budget_tolerance_ = least_tolerance_pixels;
  float error_factor_ = 1.0F;  // tolerance over the wanted error
  double headroom_ = 1.35;     // cost of a frame over its cost in the long run; a careful guess at first
  double expected_ = 0.0;      // nanoseconds, a mean over the last frames
  BindingLimit binding_ = BindingLimit::error;
  bool is_new_ = true;
};

}  // namespace throng::anim
