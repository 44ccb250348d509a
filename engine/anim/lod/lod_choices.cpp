#include "engine/anim/lod/lod_choices.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace throng::anim {
namespace {

constexpr float coarser_margin = 0.9F;  // of the allowance: a cheaper pair must be within it
constexpr float sixtieths_a_second = 60.0F;

float exact_step(float metres) { return steps_an_octave * std::log2(metres / least_allowance_metres); }

// A fade eases in and out over 0.3 s and so bends the way from one pose to the other. The poses are `apart` times the
// character's height from each other. The error comes on top of that of a walking person.
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
  if (metres < least_allowance_metres) return -1;
  return static_cast<int>(std::min(static_cast<float>(allowance_steps), exact_step(metres)));
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
  // In this order the least wins over NaN, and the most over infinity, before it becomes a whole number.
  const float finest = std::max(least_allowance_metres, metres_a_pixel * least_tolerance_pixels);
  const float step_of_finest = std::min(static_cast<float>(allowance_steps - tolerance_steps), exact_step(finest));
  const std::uint32_t* const cost = cost_.data() + static_cast<int>(step_of_finest);
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
