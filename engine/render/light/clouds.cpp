#include "engine/render/light/clouds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>

namespace throng::render {
namespace {

float random_at(int x, int y) {
  std::uint32_t bits = static_cast<std::uint32_t>(x) * 0x8DA6B343U ^ static_cast<std::uint32_t>(y) * 0xD8163841U;
  bits = (bits ^ bits >> 15U) * 0x2C1B3C6DU;
  bits = (bits ^ bits >> 12U) * 0x297A2D39U;
  return static_cast<float>((bits ^ bits >> 15U) >> 8U) * 0x1p-24F;
}

float smooth_noise(glm::vec2 place) {
  const glm::vec2 cell = glm::floor(place);
  glm::vec2 f = place - cell;
  f = f * f * f * (f * (f * 6.0F - 15.0F) + 10.0F);
  const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y);
  const float low = glm::mix(random_at(x, y), random_at(x + 1, y), f.x);
  const float high = glm::mix(random_at(x, y + 1), random_at(x + 1, y + 1), f.x);
  return glm::mix(low, high, f.y);
}

}  // namespace

glm::vec2 cloud_place(const glm::vec3& direction) {
  constexpr float bend = 0.16F;  // the layer follows the earth, so that clouds at the horizon are not endlessly far
  constexpr float clouds_overhead = 1.7F;
  return glm::vec2(direction.x, direction.z) * (clouds_overhead / (std::max(direction.y, 0.0F) + bend));
}

float cloud_noise(glm::vec2 place, int octaves) {
  float sum = 0.0F, weight = 0.5F, weights = 0.0F;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * smooth_noise(place);
    weights += weight;
    weight *= 0.5F;
    // Each octave is turned, so that no line of cells shows.
    place = glm::vec2(1.62F * place.x + 1.18F * place.y, 1.62F * place.y - 1.18F * place.x) + 7.3F;
  }
  return sum / weights;
}

float cloud_thickness(float noise, float cover) {
  if (cover <= 0.0F) return 0.0F;
  // Noise of several octaves lies between 0.25 and 0.75 nearly everywhere.
  const float least = 0.76F - 0.56F * cover;
  return glm::smoothstep(least - 0.04F, least + 0.20F, noise) * std::min(4.0F * cover, 1.0F);
}

}  // namespace throng::render
