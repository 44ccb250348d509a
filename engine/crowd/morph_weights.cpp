#include "engine/crowd/morph_weights.h"

#include <algorithm>

namespace throng {
namespace {

constexpr double least_pixels = 0.25;  // a smaller move is not seen

/// Returns how far, in pixels, the morphs of an agent can move its surface.
double pixels_moved(const anim::Character& character, const anim::VisibleAgent& agent) {
  return static_cast<double>(agent.pixels_tall) * character.morph_reach / std::max(character.bounds.height, 1e-6);
}

}  // namespace

std::uint32_t MorphWeights::add(const anim::AnimationSystem& system, const anim::Character& character,
                                const anim::VisibleAgent& agent) {
  const std::size_t count = character.morph_bones.size();
  if (count == 0 || pixels_moved(character, agent) < least_pixels) return 0;
  const std::size_t first = weights_.size();
  weights_.resize(first + count, 0.0F);
  const std::span<float> own(weights_.data() + first, count);
  const bool plays = system.agent(agent.agent).motion().add_morph_weights(system.clock(), own);
  if (plays && std::ranges::any_of(own, [](float weight) { return weight != 0.0F; })) {
    return static_cast<std::uint32_t>(first + 1);
  }
  weights_.resize(first);
  return 0;
}

}  // namespace throng
