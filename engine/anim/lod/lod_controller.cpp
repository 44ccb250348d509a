#include "engine/anim/lod/lod_controller.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace throng::anim {
namespace {

constexpr float frames_to_learn = 60.0F;
constexpr float frames_to_learn_too_much = 10.0F;  // while an error is near its limit
constexpr float aimed_error = 0.7F;                // of the limit, since a p99 of a thousand samples scatters
constexpr float error_band = 0.1F;                 // around the aim: nothing changes inside
constexpr float near_limit = 0.85F;                // of the limit: above it the factor changes fast
constexpr float most_error_factor = 8.0F;

constexpr double frames_of_change = 8.0;  // until most agents have had their turn
constexpr double headroom_rise = 0.25, headroom_fall = 1.0 / 240.0;
constexpr double most_headroom = 4.0;
constexpr double aimed_cost = 0.88;                             // of the budget
constexpr double too_much_cost = 0.93, too_little_cost = 0.82;  // of the budget: in between the tolerance stays
constexpr float sinking = 1.0F / 30.0F;                         // part of the way to a lower tolerance, a frame

double cost_at(const CostByTolerance& cost, float tolerance) {
  const float step = std::clamp(step_of_tolerance(tolerance), 0.0F, static_cast<float>(tolerance_steps - 1));
  const auto lower = static_cast<std::size_t>(step);
  const std::size_t upper = std::min<std::size_t>(lower + 1, tolerance_steps - 1);
  const double part = static_cast<double>(step) - static_cast<double>(lower);
  return static_cast<double>(cost[lower]) * (1.0 - part) + static_cast<double>(cost[upper]) * part;
}

/// Returns the least tolerance that costs at most so much, on the line between the steps around it; the largest if none
/// does.
float least_tolerance(const CostByTolerance& cost, double nanoseconds) {
  const auto* const fits =
      std::ranges::find_if(cost, [&](std::uint64_t at) { return static_cast<double>(at) <= nanoseconds; });
  if (fits == cost.begin()) return least_tolerance_pixels;
  if (fits == cost.end()) return most_tolerance_pixels;
  const auto above = static_cast<double>(*(fits - 1)), below = static_cast<double>(*fits);
  const double part = (above - nanoseconds) / std::max(above - below, 1.0);
  return tolerance_at(static_cast<float>(static_cast<double>(fits - 1 - cost.begin()) + part));
}

float towards(float from, float to, float part) { return from * std::pow(to / from, part); }

}  // namespace

void LodController::learn_error_factor(float wanted, float measured) {
  const float ratio = std::max(measured, wanted / most_error_factor) / (aimed_error * wanted);
  if (std::abs(ratio - 1.0F) <= error_band) return;
  const float frames = measured > near_limit * wanted ? frames_to_learn_too_much : frames_to_learn;
  error_factor_ =
      std::clamp(error_factor_ * std::pow(ratio, -1.0F / frames), 1.0F / most_error_factor, most_error_factor);
}

// Learns how much more a frame costs than the long run. Turns fall together, graphs are richer than counted, and levels
// stay a little longer.
void LodController::learn_headroom(const LodOutcome& outcome) {
  if (outcome.exempt_nanoseconds > outcome.nanoseconds) {
    expected_ = 0.0;  // most agents have just come into view
    return;
  }
  const double in_the_long_run = cost_at(outcome.cost_by_tolerance, tolerance_);
  if (expected_ == 0.0) expected_ = in_the_long_run;
  expected_ += (in_the_long_run - expected_) / frames_of_change;
  const double expected = std::max({expected_, in_the_long_run, 1.0});
  const double ratio = std::clamp(outcome.nanoseconds / expected, 1.0 / most_headroom, most_headroom);
  headroom_ += (ratio - headroom_) * (ratio > headroom_ ? headroom_rise : headroom_fall);
}

float LodController::budget_tolerance(const CostByTolerance& cost, double nanoseconds) const {
  const double long_run = nanoseconds / headroom_;
  const double now = cost_at(cost, budget_tolerance_);
  const float fitting = least_tolerance(cost, long_run * aimed_cost);
  if (now > long_run * too_much_cost) return fitting;
  if (now >= long_run * too_little_cost || fitting >= budget_tolerance_) return budget_tolerance_;
  return towards(budget_tolerance_, fitting, sinking);
}

void LodController::reset(const LodRules& rules) {
  *this = LodController();
  if (rules.error_pixels > 0.0F) tolerance_ = std::max(rules.error_pixels, least_tolerance_pixels);
}

void LodController::begin(const LodRules& rules, const CostByTolerance& cost) {
  budget_tolerance_ = least_tolerance(cost, budget_nanoseconds(rules) / headroom_ * aimed_cost);
  tolerance_ = std::max(rules.error_pixels, budget_tolerance_);
  is_new_ = false;
}

void LodController::settle(const LodRules& rules, const LodOutcome& outcome) {
  is_new_ = false;
  const bool error_limited = rules.error_pixels > 0.0F, budgeted = budget_nanoseconds(rules) > 0.0;
  const bool error_decides = binding_ == BindingLimit::error;
  if (error_limited && error_decides && outcome.measured_error_pixels) {
    learn_error_factor(rules.error_pixels, *outcome.measured_error_pixels);
  }
  const float for_error = error_limited ? rules.error_pixels * error_factor_ : least_tolerance_pixels;
  float for_budget = least_tolerance_pixels;
  bool fits = true;
  if (budgeted) {
    learn_headroom(outcome);
    budget_tolerance_ = budget_tolerance(outcome.cost_by_tolerance, budget_nanoseconds(rules));
    for_budget = budget_tolerance_;
    fits = static_cast<double>(outcome.cost_by_tolerance.back()) * headroom_ <= budget_nanoseconds(rules);
  }
  tolerance_ = std::clamp(std::max(for_error, for_budget), least_tolerance_pixels, most_tolerance_pixels);
  if (!fits && error_limited) {
    binding_ = BindingLimit::both_miss;
  } else if (budgeted && for_budget > for_error) {
    binding_ = BindingLimit::budget;
  } else {
    binding_ = error_limited ? BindingLimit::error : BindingLimit::none;
  }
}

const char* name_of(BindingLimit limit) {
  constexpr std::array names{"none", "error", "budget", "both miss"};
  return names.at(static_cast<std::size_t>(limit));
}

}  // namespace throng::anim
