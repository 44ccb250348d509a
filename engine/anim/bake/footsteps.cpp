#include "engine/anim/bake/footsteps.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "engine/anim/bake/ground_speed.h"
#include "engine/anim/bake/stride.h"

namespace throng::anim {

namespace {

constexpr double beside_the_middle = 0.02;  // metres: a joint nearer to the middle belongs to no side
constexpr int shortest = 4;                 // instants: a shorter stance or flight is noise

/// Says for each instant of the loop whether a side stands.
using Stances = std::array<bool, stride_instants>;

/// Returns the joints whose mean place lies on that side. A character faces +Z, so its left is +X.
std::vector<std::size_t> feet_of_side(const Stride& stride, double sign) {
  std::vector<std::size_t> feet;
  for (const std::size_t joint : stride.feet) {
    double sum = 0.0;
    for (std::size_t i = 0; i < stride_instants; ++i) sum += stride.at(i, joint).x;
    if (sign * sum / static_cast<double>(stride_instants) > beside_the_middle * stride.size) feet.push_back(joint);
  }
  return feet;
}

std::size_t wrapped(std::size_t instant) { return instant % stride_instants; }

/// Counts the instants from `instant` on that have the same stance.
int run_length(const Stances& stances, std::size_t instant) {
  int length = 1;
  while (length < static_cast<int>(stride_instants) &&
         stances[wrapped(instant + static_cast<std::size_t>(length))] == stances[instant]) {
    ++length;
  }
  return length;
}

/// Returns the first instants of the runs that stand, or that fly.
std::vector<std::size_t> beginnings(const Stances& stances, bool standing) {
  std::vector<std::size_t> instants;
  for (std::size_t i = 0; i < stride_instants; ++i) {
    if (stances[i] == standing && stances[wrapped(i + stride_instants - 1)] != standing) instants.push_back(i);
  }
  return instants;
}

void drop_short_runs(Stances& stances, bool standing) {
  for (const std::size_t begin : beginnings(stances, standing)) {
    const int length = run_length(stances, begin);
    for (int i = 0; length < shortest && i < length; ++i)
      stances[wrapped(begin + static_cast<std::size_t>(i))] = !standing;
  }
}

std::vector<std::size_t> contacts(const Stride& stride, std::span<const std::size_t> feet, const glm::dvec2& typical) {
  Stances stances{};
  for (std::size_t i = 0; i < stride_instants && !feet.empty(); ++i) {
    const std::size_t lowest = stride.lowest(i, feet);
    stances[i] = stride.is_low(i, lowest) && agrees(stride.velocity(i, lowest), typical);
  }
  drop_short_runs(stances, false);
  drop_short_runs(stances, true);
  return beginnings(stances, true);
}

struct Footstep {
  std::size_t instant;
  bool left;
};

/// Says whether left and right take turns, and no time between them is shorter than a quarter of the mean.
bool take_turns(const std::vector<Footstep>& steps) {
  if (steps.empty() || steps.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Footstep& next = steps[(i + 1) % steps.size()];
    const std::size_t gap = wrapped(next.instant + stride_instants - steps[i].instant);
    if (next.left == steps[i].left || 4 * gap * steps.size() < stride_instants) return false;
  }
  return true;
}

}  // namespace

std::vector<NamedDataKey> find_footsteps(const Skeleton& skeleton, const BakedClip& clip, double height) {
  const Stride stride = sample_stride(skeleton, clip, height);
  const glm::dvec2 typical = stance_velocity(stride);
  if (typical == glm::dvec2(0.0)) return {};
  std::vector<Footstep> steps;
  for (const bool left : {true, false}) {
    for (const std::size_t instant : contacts(stride, feet_of_side(stride, left ? 1.0 : -1.0), typical)) {
      steps.push_back({.instant = instant, .left = left});
    }
  }
  std::ranges::sort(steps, {}, &Footstep::instant);
  if (!take_turns(steps)) return {};
  std::vector<NamedDataKey> keys;
  keys.reserve(steps.size());
  for (const auto& [instant, left] : steps) {
    keys.push_back(
        {.time = stride.step * static_cast<double>(instant), .name = left ? "footstep_left" : "footstep_right"});
  }
  return keys;
}

}  // namespace throng::anim
