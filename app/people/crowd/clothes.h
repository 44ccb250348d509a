#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/people/crowd/character_look.h"
#include "app/people/crowd/layout.h"
#include "engine/base/random.h"

namespace throng::app {

/// The shapes that clothes can form.
enum class Motif : std::uint8_t {
  word,   ///< the word THRONG before the rays of a sun that rises at the far end: for a crowd that stands close
  waves,  ///< rings that swell and shrink: for tiers
  rings,  ///< rings that keep their colours while people march along them
};

/// Colours of clothes by place, which form one large shape. The word is laid out in the picture taken from a tower, so
/// it is not foreshortened there; rings are laid out on the ground. A few people wear what they like.
class ClothesPattern {
 public:
  /// Makes a pattern that fills the ground on which these places lie, as far as it is seen from the tower.
  ClothesPattern(Motif motif, std::span<const glm::dvec3> places, const CameraPose& tower);

  /// Returns the colours of a person at `place`, whose own colours are `own`. Skin and hair stay.
  Tints at(const glm::dvec3& place, const Tints& own, Random& random) const;

 private:
  glm::dvec2 in_picture(const glm::dvec3& place) const;
  double from_core(const glm::dvec3& place) const;
  void measure_ground(std::span<const glm::dvec3> places);
  const std::array<float, 3>& paint_at(const glm::dvec3& place) const;  // red, green, blue, sRGB

  Motif motif_;
  glm::dvec3 eye_, right_, up_, ahead_;
  glm::dvec2 low_{0.0}, high_{0.0};     // of the picture's part
  glm::dvec2 middle_{0.0}, half_{0.0};  // of the ground, metres
  double inner_ = 0.0;                  // metres from the core of the rings to the innermost place
};

/// Returns the shape that suits a scene of this many people: few cannot write a word.
Motif motif_of(Scene scene, std::size_t people);

/// Returns where each agent of a layout begins, in the order of agents: walkers, marchers, standers.
std::vector<glm::dvec3> places_of(const CrowdLayout& layout);

}  // namespace throng::app
