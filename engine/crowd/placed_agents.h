#pragma once

#include <cstdint>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "throng/heading.h"

namespace throng {

/// The characters of the agents, and where they stand. The spans are parallel, one element an agent.
struct PlacedAgents {
  std::span<const glm::vec3> positions;  ///< metres, world space, between the feet
  std::span<const Heading> headings;
  std::span<const float> scales;
  std::span<const std::uint8_t> characters;  ///< index among the characters of the view

  /// Returns the matrix from the model space of an agent to the world.
  glm::mat4 model_to_world(std::uint32_t agent) const {
    const Heading heading = headings[agent];
    const float scale = scales[agent];
    return {glm::vec4(heading.cosine, 0.0F, -heading.sine, 0.0F) * scale, glm::vec4(0.0F, scale, 0.0F, 0.0F),
            glm::vec4(heading.sine, 0.0F, heading.cosine, 0.0F) * scale, glm::vec4(positions[agent], 1.0F)};
  }
};

}  // namespace throng
