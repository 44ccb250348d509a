#include "app/show/morph_weights.h"

#include <algorithm>

#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

constexpr double least_pixels = 0.25;  // a smaller move is not seen

/// Returns how far, in pixels, the morphs of an agent can move its surface.
double pixels_moved(const anim::Character& character, const anim::VisibleAgent& agent) {
  return static_cast<double>(agent.pixels_tall) * character.morph_reach / std::max(character.bounds.height, 1e-6);
}

}  // namespace

std::uint32_t MorphWeights::add(const Stage& stage, const anim::VisibleAgent& agent) {
  const anim::Character& character = *stage.character_of(agent.agent).character;
  const std::size_t count = character.morph_bones.size();
  if (count == 0 || pixels_moved(character, agent) < least_pixels) return 0;
  const std::size_t first = weights_.size();
  weights_.resize(first + count, 0.0F);
  const std::span<float> own(weights_.data() + first, count);
  const bool plays = stage.system().agent(agent.agent).motion().add_morph_weights(stage.system().clock(), own);
  if (plays && std::ranges::any_of(own, [](float weight) { return weight != 0.0F; })) {
    return static_cast<std::uint32_t>(first + 1);
  }
  weights_.resize(first);
  return 0;
}

}  // namespace throng::app
