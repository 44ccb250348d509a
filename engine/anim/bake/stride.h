#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/bake/character.h"

namespace throng::anim {

inline constexpr std::size_t stride_instants = 96;

/// The places of a clip's joints at even steps through it, and the joints that may be feet.
struct Stride {
  std::vector<std::vector<glm::dvec3>> joints;  ///< [0..stride_instants][bone], model space
  std::vector<std::size_t> feet;  ///< bones that rest low, and go to and fro over the ground, not only up and down
  double step = 0.0;              ///< seconds between instants
  double size = 1.0;              ///< the character's height over 1.8 m
  double ground = 0.0;            ///< metres, the least height of any foot

  const glm::dvec3& at(std::size_t instant, std::size_t joint) const { return joints[instant][joint]; }
  std::size_t lowest(std::size_t instant, std::span<const std::size_t> among) const;
  /// Says whether a joint is so low that it may bear weight.
  bool is_low(std::size_t instant, std::size_t joint) const;
  /// Returns metres a second over the ground, x and z, until the next instant; `instant` is not the last.
  glm::dvec2 velocity(std::size_t instant, std::size_t joint) const;
};
Stride sample_stride(const Skeleton& skeleton, const BakedClip& clip, double height);

/// Says whether a foot that moves at `velocity` over the ground stands, where standing feet move at about `typical`.
bool agrees(const glm::dvec2& velocity, const glm::dvec2& typical);

}  // namespace throng::anim
