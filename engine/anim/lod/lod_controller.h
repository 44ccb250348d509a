#pragma once

#include <cstdint>
#include <optional>

#include "engine/anim/lod/lod_cost.h"

namespace throng::anim {

/// What level of detail may cost; 0: no such limit.
struct LodLimits {
  float error_pixels = 1.0F;        ///< that 99% of what is shown stay below
  double budget_nanoseconds = 0.0;  ///< a frame, predicted, summed over PUs; those who reappear are exempt

  friend bool operator==(const LodLimits&, const LodLimits&) = default;
};

enum class BindingLimit : std::uint8_t {
  none,       ///< the finest there is fits the budget
  error,      ///< more could be saved if the error might be larger
  budget,     ///< the error could be smaller if more might be spent; the limit on the error gives way to it
  both_miss,  ///< two limits, and even the coarsest there is does not fit the budget
};

/// What the last frame came to.
struct LodOutcome {
  CostByTolerance cost_by_tolerance{};
  double nanoseconds = 0.0;                         ///< predicted, of all that was posed and is not exempt
  double exempt_nanoseconds = 0.0;                  ///< the same of those who came into view
  std::optional<float> measured_error_pixels = {};  ///< p99 over the last frames; none: too little was measured
};

/// Turns the one knob, LodRules::tolerance_pixels, so that the limits hold. Frame by frame from the outcome of the
/// last; depends on outcomes alone, so that a replay decides alike.
///
/// The error's limit asks for the tolerance at which the measured error comes out below it: a slow factor. The budget's
/// asks for the least tolerance at which the predicted cost fits, found in the histogram in one step when it must rise,
/// and approached slowly when it may sink; in between lies a band in which nothing moves. The larger of the two is
/// taken.
class LodController {
 public:
  /// Before the first frame, and when the crowd starts anew.
  void reset(const LodLimits& limits);

  /// No frame has been settled since.
  bool is_new() const { return is_new_; }
  /// With a budget, before the first frame: from what those in view would cost.
  void begin(const LodLimits& limits, const CostByTolerance& cost);

  void settle(const LodLimits& limits, const LodOutcome& outcome);

  float tolerance_pixels() const { return tolerance_; }
  BindingLimit binding() const { return binding_; }

 private:
  void learn_error_factor(float wanted, float measured);
  void learn_headroom(const LodOutcome& outcome);
  float budget_tolerance(const CostByTolerance& cost, double nanoseconds) const;

  float tolerance_ = 1.0F;
  float budget_tolerance_ = least_tolerance_pixels;
  float error_factor_ = 1.0F;  // tolerance over the error that is wanted
  double headroom_ = 1.35;     // what frames come to, over what they would in the long run; at first a careful guess
  double expected_ = 0.0;      // nanoseconds, of the last frames
  BindingLimit binding_ = BindingLimit::error;
  bool is_new_ = true;
};

}  // namespace throng::anim
