#include "engine/anim/lod/lod_choices.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace throng::anim {
namespace {

constexpr float coarser_margin = 0.9F;  // of the allowance: a cheaper pair must be within it
constexpr float sixtieths_a_second = 60.0F;

float exact_step(float metres) { return steps_an_octave * std::log2(metres / least_allowance_metres); }

constexpr std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

/// Returns the least allowance whose step is `step`; steps grow with allowances, so it is found by halving.
float begin_of_step(int step) {
  std::uint32_t below = bits_of(least_allowance_metres * 0.5F), at = bits_of(std::numeric_limits<float>::max());
  while (at - below > 1) {
    const std::uint32_t middle = below + (at - below) / 2;
    (exact_step(std::bit_cast<float>(middle)) >= static_cast<float>(step) ? at : below) = middle;
  }
  return std::bit_cast<float>(at);
}

/// The least allowance of each step, so that no agent takes a logarithm; [0] is least_allowance_metres.
const auto begins_of_steps = [] {
  std::array<float, allowance_steps + 1> begins{};
  for (int step = 0; step <= allowance_steps; ++step) begins[static_cast<std::size_t>(step)] = begin_of_step(step);
  return begins;
}();

// A fade eases in and out over 0.3 s and so bends the way from one pose to the other. The poses are `apart` times the
// character's height from each other. The error comes on top of a walking person's.
SkipError error_of_change(float height) {
  constexpr float apart = 0.3F, fade_sixtieths = 18.0F;
  SkipError error;
  for (std::size_t i = 0; i < SkipError::spans.size(); ++i) {
    const float part = std::min(static_cast<float>(SkipError::spans[i]) / fade_sixtieths, 1.0F);
    error.blended[i] += 0.75F * part * part * apart * height;  // an eighth of the span squared times curvature
    error.held[i] += 1.5F * part * apart * height;             // the ease's steepest slope
  }
  return error;
}

float metres_at(int step) { return least_allowance_metres * std::exp2(static_cast<float>(step) / steps_an_octave); }

}  // namespace

int allowance_step(float metres) {
  if (!(metres >= least_allowance_metres)) return -1;
  if (metres >= begins_of_steps.back()) return allowance_steps;
  // The upper bits are the octave and the eighth of it, a step below the one on the logarithm's scale at most.
  static_assert(steps_an_octave == 8);
  auto step = (bits_of(metres) >> 20U) - (bits_of(least_allowance_metres) >> 20U);
  while (metres >= begins_of_steps[step + 1]) ++step;
  while (metres < begins_of_steps[step]) --step;
  return static_cast<int>(step);
}

MotionLod::MotionLod(const LodCharacter& character, const SkipError& motion, const LodRules& rules,
                     float frame_seconds) {
  update_cost_ = character.update_nanoseconds;
  full_rate_cost_ = character.full_rate_nanoseconds;
  for (std::size_t level = 0; level < error_.size(); ++level) {
    for (std::size_t frames = 1; frames <= error_[level].size(); ++frames) {
      const float sixtieths = static_cast<float>(frames) * frame_seconds * sixtieths_a_second;
      const float skipped = frames == 1 ? 0.0F : motion.metres(sixtieths, rules.smooth);
      error_[level][frames - 1] = character.level_error_metres[level] + skipped;
    }
  }
  const std::vector<Pair> pairs = cheapest_first(rules.bone_lod ? character.level_count : 1, rules.largest_interval);
  for (int step = 0; step < allowance_steps; ++step) {
    const float allowed = metres_at(step);
    const auto found = std::ranges::find_if(pairs, [allowed](const Pair& pair) { return pair.error <= allowed; });
    const Pair exact{.choice = {}, .cost = cost({}), .error = 0.0F};
    const Pair& best = found == pairs.end() ? exact : *found;
    choice_[static_cast<std::size_t>(step)] = best.choice;
    cost_[static_cast<std::size_t>(step)] = static_cast<std::uint32_t>(best.cost);
  }
}

std::vector<MotionLod::Pair> MotionLod::cheapest_first(int levels, int intervals) const {
  std::vector<Pair> pairs;
  for (int level = 0; level < levels; ++level) {
    for (int interval = 1; interval <= intervals; ++interval) {
      const LodChoice choice{static_cast<std::uint8_t>(interval), static_cast<std::uint8_t>(level)};
      pairs.push_back({choice, cost(choice), error_metres(choice)});
    }
  }
  std::ranges::stable_sort(pairs, {}, [](const Pair& pair) { return std::tuple(pair.cost, pair.error); });
  return pairs;
}

LodChoice MotionLod::choose(float metres, LodChoice shown) const {
  const LodChoice coarser = choose(metres * coarser_margin);
  const bool may_stay = error_metres(shown) <= metres && cost(coarser) >= cost(shown);
  return may_stay ? shown : coarser;
}

std::size_t MotionLod::clamped(int step) { return static_cast<std::size_t>(std::clamp(step, 0, allowance_steps - 1)); }

void MotionLod::add_cost(float metres_a_pixel, std::span<std::uint32_t, tolerance_steps> by_tolerance) const {
  const int step_of_finest = allowance_step(metres_a_pixel * least_tolerance_pixels);
  const std::uint32_t* const cost = cost_.data() + std::clamp(step_of_finest, 0, allowance_steps - tolerance_steps);
  for (std::size_t step = 0; step < tolerance_steps; ++step) by_tolerance[step] += cost[step];
}

void LodChoices::build(std::span<const LodCharacter> characters, const LodRules& rules, float frame_seconds) {
  motions_.clear();
  first_.assign(1, 0);
  for (const LodCharacter& character : characters) {
    motions_.emplace_back(character, error_of_change(character.height), rules, frame_seconds);
    motions_.emplace_back(character, no_skip_error, rules, frame_seconds);
    for (const SkipError& clip : character.clips) motions_.emplace_back(character, clip, rules, frame_seconds);
    first_.push_back(motions_.size());
  }
}

}  // namespace throng::anim
