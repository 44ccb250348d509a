#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "throng/render/crowd_mesh_data.h"

#include "engine/render/mesh/surface.h"

namespace throng::render {

/// A point of a surface: the vertices of its triangle, and their weights there.
struct SurfacePoint {
  std::array<std::uint32_t, 3> vertices{};
  glm::vec3 weights{1.0F, 0.0F, 0.0F};
};

/// Describes a point as a person sees it.
struct PointLook {
  glm::vec3 color{1.0F};  ///< square roots of linear values, about as bright as they look
  std::uint8_t region = untinted_region;
  bool double_sided = false;
  bool cut_out = false;       ///< nothing is seen
  bool seen_through = false;  ///< surfaces behind it are seen, too
};

/// Returns whether a person can hardly tell the points apart by their colours.
bool look_alike(const PointLook& a, const PointLook& b);

/// The colours of a surface: of its vertices, materials and textures, which are read at a few millimetres' resolution.
/// Adds the emitted light to the base colour, as if the light were white.
class SurfacePaint {
 public:
  /// All parameters outlive the paint. `materials` has one a vertex.
  SurfacePaint(const Surface& surface, std::span<const int> materials, const CrowdMeshData& data);

  PointLook look(const SurfacePoint& point) const;

 private:
  struct SmallImage {
    int width = 0, height = 0;
    std::vector<glm::u8vec4> texels;  // sRGB
  };

  static SmallImage small_image(const ImageData& image);
  glm::vec4 texel(const TextureData& texture, const glm::vec2& place) const;

  const Surface& surface_;
  std::span<const int> materials_;
  std::span<const MaterialData> by_index_;
  std::vector<SmallImage> images_;  // empty where no material shows the image
};

}  // namespace throng::render
