#include "engine/render/mesh/surface_paint.h"

#include <algorithm>
#include <cmath>

#include <glad/gl.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

namespace throng::render {
namespace {

constexpr int largest_texture = 512;  // texels a side: 3 mm of a person's skin
constexpr float alike = 0.2F;         // of a color's channel
constexpr float full_color = 65535.0F;
constexpr float least_seen = 0.1F;    // alpha of blended surfaces; less is as good as nothing
constexpr float least_hiding = 0.9F;  // alpha of blended surfaces; more hides all behind

// A square root is near enough to the curve of sRGB, whose values textures have.
glm::vec4 as_seen(const glm::vec4& linear) {
  return {glm::sqrt(glm::max(glm::vec3(linear), glm::vec3(0.0F))), linear.a};
}

/// Returns the column or row of a texture coordinate, as its sampler wraps it.
int texel_at(float coord, int count, int wrap) {
  const float clamped = glm::clamp(coord, 0.0F, 1.0F);
  const float in_two = coord - 2.0F * glm::floor(coord / 2.0F);  // a picture and its mirror image
  const float mirrored = in_two > 1.0F ? 2.0F - in_two : in_two;
  const float repeated = coord - glm::floor(coord);
  const float wrapped = wrap == GL_CLAMP_TO_EDGE ? clamped : wrap == GL_MIRRORED_REPEAT ? mirrored : repeated;
  if (!(wrapped >= 0.0F)) return 0;  // a coordinate that is no number
  return std::min(static_cast<int>(wrapped * static_cast<float>(count)), count - 1);
}

}  // namespace

bool look_alike(const PointLook& a, const PointLook& b) {
  if (a.cut_out || b.cut_out || a.region != b.region) return a.cut_out && b.cut_out;
  const glm::vec3 difference = glm::abs(a.color - b.color);
  return std::max({difference.r, difference.g, difference.b}) <= alike;
}

SurfacePaint::SurfacePaint(const Surface& surface, std::span<const int> materials, const CrowdMeshData& data)
    : surface_(surface), materials_(materials), by_index_(data.materials), images_(data.images.size()) {
  const auto add = [&](const TextureData& texture) {
    if (texture.image < 0) return;
    SmallImage& image = images_[static_cast<std::size_t>(texture.image)];
    if (image.texels.empty()) image = small_image(data.images[static_cast<std::size_t>(texture.image)]);
  };
  for (const MaterialData& material : data.materials) {
    add(material.base_color_texture);
    add(material.emission_texture);
  }
}

SurfacePaint::SmallImage SurfacePaint::small_image(const ImageData& image) {
  int step = 1;
  while (std::max(image.width, image.height) / step > largest_texture) step *= 2;
  SmallImage small{.width = std::max(image.width / step, 1), .height = std::max(image.height / step, 1), .texels = {}};
  small.texels.reserve(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  const auto texel = [&image](int x, int y) {
    const int column = std::min(x, image.width - 1), row = std::min(y, image.height - 1);
    const auto first =
        (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column)) * 4;
    return glm::vec4(image.rgba[first], image.rgba[first + 1], image.rgba[first + 2], image.rgba[first + 3]);
  };
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      glm::vec4 sum(0.0F);
      for (int i = 0; i < step * step; ++i) sum += texel(x * step + i % step, y * step + i / step);
      small.texels.emplace_back(sum / static_cast<float>(step * step));
    }
  }
  return small;
}

glm::vec4 SurfacePaint::texel(const TextureData& texture, const glm::vec2& place) const {
  if (texture.image < 0) return glm::vec4(1.0F);
  const SmallImage& image = images_[static_cast<std::size_t>(texture.image)];
  const int x = texel_at(place.x, image.width, texture.wrap_u), y = texel_at(place.y, image.height, texture.wrap_v);
  const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
  return glm::vec4(image.texels[index]) / 255.0F;
}

PointLook SurfacePaint::look(const SurfacePoint& point) const {
  glm::vec4 color(0.0F);
  glm::vec2 place(0.0F), emission_place(0.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t index = point.vertices.at(i);
    const SurfaceVertex& vertex = surface_.vertices[index];
    const float weight = point.weights[static_cast<glm::length_t>(i)];
    color += weight / full_color * glm::vec4(vertex.color[0], vertex.color[1], vertex.color[2], vertex.color[3]);
    place += weight * glm::vec2(vertex.texture_coord[0], vertex.texture_coord[1]);
    if (surface_.detail_coords.empty()) continue;
    const TextureCoord& emission = surface_.detail_coords[index].emission;
    emission_place += weight * glm::vec2(emission[0], emission[1]);
  }
  if (surface_.detail_coords.empty()) emission_place = place;
  const MaterialData& material = by_index_[static_cast<std::size_t>(materials_[point.vertices[0]])];
  for (int i = 0; i < 4; ++i) color[i] *= material.base_color[i];
  color = as_seen(color) * texel(material.base_color_texture, place);
  const glm::vec4 emission(material.emission[0], material.emission[1], material.emission[2], 0.0F);
  const glm::vec3 shining(as_seen(emission) * texel(material.emission_texture, emission_place));
  return {.color = glm::sqrt(glm::vec3(color) * glm::vec3(color) + shining * shining),
          .region = surface_.vertices[point.vertices[0]].region,
          .double_sided = material.double_sided,
          .cut_out = color.a < (material.blended ? least_seen : material.alpha_cutoff),
          .seen_through = color.a < (material.blended ? least_hiding : material.alpha_cutoff)};
}

}  // namespace throng::render
