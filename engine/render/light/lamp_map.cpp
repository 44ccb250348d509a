#include "engine/render/light/lamp_map.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/render/frame/frame_data.h"

namespace throng::render {
namespace {

constexpr float breast = 1.2F;           // metres
constexpr float reach_of_height = 6.0F;  // a lamp shines this many times as far as it hangs above that
constexpr float above_lamps = 1.6F;      // the ceiling over the height of the highest lamp

float reach_of(const SceneryLamp& lamp) { return reach_of_height * std::max(lamp.position.y - breast, 0.5F); }

/// Returns the light of a lamp of strength 1 at a distance along the ground. It ends at the lamp's reach.
float share_at(const SceneryLamp& lamp, float distance) {
  const float height = std::max(lamp.position.y - breast, 0.5F);
  const float left = 1.0F - std::pow(distance / reach_of(lamp), 2.0F);
  if (left <= 0.0F) return 0.0F;
  return height / std::pow(distance * distance + height * height, 1.5F) * left * left;
}

void lay_over(std::span<const SceneryLamp> lamps, LampLight& light) {
  glm::vec2 low(1e9F), high(-1e9F);
  for (const SceneryLamp& lamp : lamps) {
    const glm::vec2 place(lamp.position.x, lamp.position.z);
    low = glm::min(low, place - reach_of(lamp));
    high = glm::max(high, place + reach_of(lamp));
    light.ceiling = std::max(light.ceiling, above_lamps * lamp.position.y);
  }
  light.metres = std::max(high.x - low.x, high.y - low.y);
  light.corner = 0.5F * (low + high - light.metres);
}

void add_lamp(const SceneryLamp& lamp, LampLight& light) {
  const float pixel = light.metres / LampLight::side;
  const glm::vec2 middle = (glm::vec2(lamp.position.x, lamp.position.z) - light.corner) / pixel;
  const float reach = reach_of(lamp) / pixel;
  const glm::ivec2 first = glm::max(glm::ivec2(middle - reach), glm::ivec2(0));
  const glm::ivec2 last = glm::min(glm::ivec2(middle + reach), glm::ivec2(LampLight::side - 1));
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      const float distance = pixel * glm::distance(glm::vec2(x, y) + 0.5F, middle);
      light.pixels[static_cast<std::size_t>(y) * LampLight::side + static_cast<std::size_t>(x)] +=
          glm::vec4(lamp.color * share_at(lamp, distance), 0.0F);
    }
  }
}

}  // namespace

LampLight sum_of_lamps(std::span<const SceneryLamp> lamps) {
  LampLight light;
  if (lamps.empty()) return light;
  lay_over(lamps, light);
  light.pixels.resize(std::size_t{LampLight::side} * LampLight::side);
  for (const SceneryLamp& lamp : lamps) add_lamp(lamp, light);
  return light;
}

void LampMap::place(std::span<const SceneryLamp> lamps) {
  const LampLight light = sum_of_lamps(lamps);
  map_ = gl::Texture();
  lies_at_ = glm::vec4(0.0F);
  if (light.pixels.empty()) return;
  lies_at_ = {light.corner, 1.0F / light.metres, light.ceiling};
  map_ = gl::create_texture(GL_RGBA16F, LampLight::side, LampLight::side);
  const GLuint id = map_.id();
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glTextureSubImage2D(id, 0, 0, 0, LampLight::side, LampLight::side, GL_RGBA, GL_FLOAT, light.pixels.data());
}

void LampMap::describe(ShadowUniforms& uniforms) const {
  uniforms.lamp_map = lies_at_;
  if (map_) glBindTextureUnit(lamp_map_unit, map_.id());
}

}  // namespace throng::render
