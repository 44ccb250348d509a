#include "engine/render/mesh/surface_paint.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/gtc/type_precision.hpp>

namespace throng::render {
namespace {

constexpr int largest_texture = 512;  // texels a side: 3 mm of a person's skin
constexpr float alike = 0.2F;         // of a color's channel
constexpr float full_color = 65535.0F;

// A square root is near enough to the curve of sRGB, whose values textures have.
glm::vec4 as_seen(const glm::vec4& linear) {
  return {glm::sqrt(glm::max(glm::vec3(linear), glm::vec3(0.0F))), linear.a};
}

/// Returns the texel of a repeated texture; the first for a coordinate that is no number.
int texel_at(float coordinate, int size) {
  const float wrapped = coordinate - std::floor(coordinate);
  return wrapped >= 0.0F ? std::min(static_cast<int>(wrapped * static_cast<float>(size)), size - 1) : 0;
}

}  // namespace

bool look_alike(const PointLook& a, const PointLook& b) {
  if (a.cut_out || b.cut_out || a.region != b.region) return a.cut_out && b.cut_out;
  const glm::vec3 difference = glm::abs(a.color - b.color);
  return std::max({difference.r, difference.g, difference.b}) <= alike;
}

SurfacePaint::SurfacePaint(std::span<const SurfaceVertex> vertices, std::span<const int> materials,
                           const CrowdMeshData& data)
    : vertices_(vertices), materials_(materials), by_index_(data.materials) {
  for (const ImageData& image : data.images) textures_.push_back(small_texture(image));
}

SurfacePaint::Texture SurfacePaint::small_texture(const ImageData& image) {
  int step = 1;
  while (std::max(image.width, image.height) / step > largest_texture) step *= 2;
  Texture small{.width = std::max(image.width / step, 1), .height = std::max(image.height / step, 1), .texels = {}};
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

PointLook SurfacePaint::look(const SurfacePoint& point) const {
  glm::vec4 color(0.0F);
  glm::vec2 place(0.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    const SurfaceVertex& vertex = vertices_[point.vertices.at(i)];
    const float weight = point.weights[static_cast<glm::length_t>(i)];
    color += weight / full_color * glm::vec4(vertex.color[0], vertex.color[1], vertex.color[2], vertex.color[3]);
    place += weight * glm::vec2(vertex.texture_coord[0], vertex.texture_coord[1]);
  }
  const MaterialData& material = by_index_[static_cast<std::size_t>(materials_[point.vertices[0]])];
  for (int i = 0; i < 4; ++i) color[i] *= material.base_color[i];
  color = as_seen(color);
  if (material.image >= 0) {
    const Texture& texture = textures_[static_cast<std::size_t>(material.image)];
    const int index = texel_at(place.y, texture.height) * texture.width + texel_at(place.x, texture.width);
    color *= glm::vec4(texture.texels[static_cast<std::size_t>(index)]) / 255.0F;
  }
  return {.color = glm::vec3(color),
          .region = vertices_[point.vertices[0]].region,
          .double_sided = material.double_sided,
          .cut_out = color.a < material.alpha_cutoff};
}

}  // namespace throng::render
