#include "engine/render/mesh/coverage.h"

#include <algorithm>
#include <cstddef>

#include "engine/render/mesh/mesh_parts.h"

namespace throng::render {
namespace {

float least_alpha_of(const ImageData& image) {
  std::uint8_t least = 255;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) least = std::min(least, image.rgba[i]);
  return static_cast<float>(least) / 255.0F;
}

float least_alpha_of(const MeshPartData& part) {
  float least = 1.0F;
  for (std::size_t i = 3; i < part.colors.size(); i += 4) least = std::min(least, part.colors[i]);
  return least;
}

/// Returns the least alpha that any point with the material can have.
float least_alpha(const CrowdMeshData& data, int material) {
  const MaterialData& used = data.materials[static_cast<std::size_t>(material)];
  float of_colors = 1.0F;
  const auto add_part = [&](const MeshPartData& part) {
    if (part.material == material) of_colors = std::min(of_colors, least_alpha_of(part));
  };
  for_each_part(data, add_part);
  const int image = used.base_color_texture.image;
  const float of_texture = image < 0 ? 1.0F : least_alpha_of(data.images[static_cast<std::size_t>(image)]);
  return used.base_color[3] * of_colors * of_texture;
}

}  // namespace

Coverage coverage_of(const CrowdMeshData& data, int material) {
  const MaterialData& used = data.materials[static_cast<std::size_t>(material)];
  if (used.blended) return least_alpha(data, material) >= 1.0F ? Coverage::opaque : Coverage::blended;
  if (used.alpha_cutoff <= 0.0F) return Coverage::opaque;
  return least_alpha(data, material) >= used.alpha_cutoff ? Coverage::opaque : Coverage::cut_out;
}

}  // namespace throng::render
