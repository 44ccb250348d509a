#include "app/show/stage/stances.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/anim/bake/stride.h"
#include "engine/anim/rig/limbs.h"

namespace throng::app {
namespace {

constexpr double low = 0.03;       // metres over where the ball is lowest, of a person 1.8 m tall
constexpr double off_by = 0.5;     // of the gait's speed, by which a standing foot may go at another one
constexpr double still = 0.15;     // metres a second, which a foot that stands does not exceed
constexpr float settling = 0.04F;  // of a cycle, in which a foot comes down or is lifted
constexpr std::size_t instants = anim::stride_instants;

using Standing = std::array<bool, instants>;

Standing standing_of(const anim::Stride& stride, std::size_t ball, const glm::dvec2& gait) {
  double lowest = stride.at(0, ball).y;
  for (std::size_t i = 0; i < instants; ++i) lowest = std::min(lowest, stride.at(i, ball).y);
  const double most = std::max(off_by * glm::length(gait), still * stride.size);
  Standing standing{};
  for (std::size_t i = 0; i < instants; ++i) {
    const bool is_low = stride.at(i, ball).y < lowest + low * stride.size;
    standing[i] = is_low && glm::length(stride.velocity(i, ball) + gait) < most;
  }
  return standing;
}

anim::MarkedClip marked(const anim::BakedClip& clip) {
  return {.keys = clip.data_keys, .duration = std::max(clip.duration, Ticks{1})};
}

std::size_t run_from(const Standing& standing, std::size_t first) {
  std::size_t length = 0;
  while (length < instants && standing[(first + length) % instants]) ++length;
  return length;
}

}  // namespace

Stances::Stances(const anim::Character& character, const StridePlane& plane) : of_(plane.points().size()) {
  const auto clip_of = [&](std::size_t point) -> const anim::BakedClip& {
    return character.clips[static_cast<std::size_t>(plane.points()[point].gait.clip)];
  };
  for (std::size_t point = 0; point < of_.size(); ++point) {
    in_step_.emplace_back(marked(clip_of(plane.reference())), marked(clip_of(point)));
  }
  const anim::Limbs limbs = anim::find_limbs(character.skeleton);
  const std::array legs{limbs.left_leg, limbs.right_leg};
  for (std::size_t point = 0; point < of_.size(); ++point) {
    const GaitPoint& gait = plane.points()[point].gait;
    if (!gait.is_gait) continue;
    const anim::Stride stride = anim::sample_stride(character.skeleton, clip_of(point), character.height);
    for (std::size_t leg = 0; leg < person_legs; ++leg) {
      if (!legs[leg]) continue;
      const int ball = legs[leg]->tip >= 0 ? legs[leg]->tip : legs[leg]->end;
      const Standing standing = standing_of(stride, static_cast<std::size_t>(ball), glm::dvec2(gait.velocity));
      std::size_t longest = 0;
      for (std::size_t i = 0; i < instants; ++i) {
        if (!standing[i] || standing[(i + instants - 1) % instants]) continue;
        const std::size_t length = run_from(standing, i);
        if (length <= longest) continue;
        longest = length;
        of_[point][leg] = {.down = static_cast<float>(i) / instants, .length = static_cast<float>(length) / instants};
      }
    }
  }
}

float Stances::margin(std::size_t point, std::size_t leg, double phase) const {
  const Stance& stance = of_[point][leg];
  // Seen from the middle of the stance, where the ends lie alike.
  const float from_middle = static_cast<float>(phase) - stance.down - 0.5F * stance.length;
  const float away = std::abs(from_middle - std::round(from_middle));
  return 0.5F + (0.5F * stance.length - away) / settling;
}

}  // namespace throng::app
