#include "engine/anim/import/specular_glossiness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/common.hpp>

#include "engine/base/srgb.h"

namespace throng::import {
namespace {

constexpr float dielectric = 0.04F;  // share of light that surfaces without metal mirror head on
constexpr float least = 1e-6F;

float largest(const glm::vec3& color) { return std::max({color.r, color.g, color.b}); }

float brightness(const glm::vec3& color) {
  return std::sqrt(0.299F * color.r * color.r + 0.587F * color.g * color.g + 0.114F * color.b * color.b);
}

/// Returns how much metal a mixture has that reflects so much: the root of a quadratic equation.
float metallic_of(float diffuse, float specular, float scattered_share) {
  if (specular < dielectric) return 0.0F;
  const float b = diffuse * scattered_share / (1.0F - dielectric) + specular - 2.0F * dielectric;
  const float c = dielectric - specular;
  const float discriminant = std::max(b * b - 4.0F * dielectric * c, 0.0F);
  return std::clamp((std::sqrt(discriminant) - b) / (2.0F * dielectric), 0.0F, 1.0F);
}

std::uint8_t to_srgb(float linear) { return to_byte(srgb_of_light(linear)); }

/// Reads an sRGB image with linear alpha at the middle of a texel of a larger one, between its own texels.
class ImageReader {
 public:
  ImageReader(const anim::Image& image, const glm::ivec2& sides)
      : image_(image), step_(glm::vec2(image.width, image.height) / glm::vec2(sides)) {}

  glm::vec4 at(int x, int y) const {
    if (image_.rgba.empty()) return glm::vec4(1.0F);
    const glm::vec2 place = glm::max((glm::vec2(x, y) + 0.5F) * step_ - 0.5F, glm::vec2(0.0F));
    const glm::ivec2 low(place);
    const glm::vec2 share = place - glm::vec2(low);
    if (share == glm::vec2(0.0F)) return texel(low.x, low.y);
    return glm::mix(glm::mix(texel(low.x, low.y), texel(low.x + 1, low.y), share.x),
                    glm::mix(texel(low.x, low.y + 1), texel(low.x + 1, low.y + 1), share.x), share.y);
  }

 private:
  glm::vec4 texel(int x, int y) const {
    const auto column = static_cast<std::size_t>(std::min(x, image_.width - 1));
    const auto row = static_cast<std::size_t>(std::min(y, image_.height - 1));
    const std::uint8_t* rgba = &image_.rgba[(row * static_cast<std::size_t>(image_.width) + column) * 4];
    const std::array<float, 256>& light = lights_of_srgb();
    return {light.at(rgba[0]), light.at(rgba[1]), light.at(rgba[2]), static_cast<float>(rgba[3]) / 255.0F};
  }

  const anim::Image& image_;
  glm::vec2 step_;
};

using Pixels = std::vector<std::uint8_t>;

anim::Image image_of(const std::shared_ptr<Pixels>& pixels, const glm::ivec2& sides) {
  return {.width = sides.x, .height = sides.y, .rgba = *pixels, .lender = pixels};
}

}  // namespace

MetallicRoughness to_metallic_roughness(const SpecularGlossiness& point) {
  const glm::vec3 diffuse(point.diffuse);
  const float scattered_share = 1.0F - largest(point.specular);
  const float metallic = metallic_of(brightness(diffuse), brightness(point.specular), scattered_share);
  const glm::vec3 of_diffuse = diffuse * (scattered_share / (1.0F - dielectric) / std::max(1.0F - metallic, least));
  const glm::vec3 of_specular = (point.specular - dielectric * (1.0F - metallic)) / std::max(metallic, least);
  const glm::vec3 color = glm::clamp(glm::mix(of_diffuse, of_specular, metallic * metallic), 0.0F, 1.0F);
  return {.base_color = glm::vec4(color, point.diffuse.a), .metallic = metallic, .roughness = 1.0F - point.glossiness};
}

glm::ivec2 sides_of_both(const anim::Image& diffuse, const anim::Image& specular_glossiness) {
  return glm::max(glm::ivec2(diffuse.width, diffuse.height),
                  glm::ivec2(specular_glossiness.width, specular_glossiness.height));
}

MetallicRoughnessImages to_metallic_roughness(const anim::Image& diffuse, const anim::Image& specular_glossiness,
                                              const SpecularGlossiness& factors) {
  const glm::ivec2 sides = sides_of_both(diffuse, specular_glossiness);
  const ImageReader diffuse_reader(diffuse, sides), specular_reader(specular_glossiness, sides);
  const auto colors = std::make_shared<Pixels>(), numbers = std::make_shared<Pixels>();
  const std::size_t bytes = static_cast<std::size_t>(sides.x) * static_cast<std::size_t>(sides.y) * 4;
  colors->reserve(bytes);
  numbers->reserve(bytes);
  for (int y = 0; y < sides.y; ++y) {
    for (int x = 0; x < sides.x; ++x) {
      const glm::vec4 specular = specular_reader.at(x, y);
      const MetallicRoughness point =
          to_metallic_roughness(SpecularGlossiness{.diffuse = factors.diffuse * diffuse_reader.at(x, y),
                                                   .specular = factors.specular * glm::vec3(specular),
                                                   .glossiness = factors.glossiness * specular.a});
      for (int c = 0; c < 3; ++c) colors->push_back(to_srgb(point.base_color[c]));
      colors->push_back(to_byte(point.base_color.a));
      numbers->insert(numbers->end(), {255, to_byte(point.roughness), to_byte(point.metallic), 255});
    }
  }
  return {.base_color = image_of(colors, sides), .metallic_roughness = image_of(numbers, sides)};
}

}  // namespace throng::import
