#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/crowd/character_look.h"
#include "app/crowd/layout.h"
#include "app/crowd/random.h"

namespace throng::app {

/// Colours of clothes by place, which form one large shape that is seen from above: a sun within rings that wave. A few
/// people wear what they like.
class ClothesPattern {
 public:
  /// Makes a pattern that fills the ground on which these places lie.
  explicit ClothesPattern(std::span<const glm::dvec2> places);

  /// Returns the colours of somebody at `place`, whose own colours are `own`. Skin and hair stay.
  Tints at(glm::dvec2 place, const Tints& own, Random& random) const;

 private:
  glm::dvec2 middle_{0.0}, half_{1.0};  // metres
};

/// Returns where each agent of a layout begins, in the order of agents: walkers, marchers, standers.
std::vector<glm::dvec2> places_of(const CrowdLayout& layout);

}  // namespace throng::app
