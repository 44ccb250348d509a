#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace throng::render {

/// Plain data in, by which app/ hands a character's surface to drawing. All spans of one part have `vertex_count`
/// elements.
struct MeshPartData {
  std::span<const float> positions;                ///< x y z, in the space of the palette
  std::span<const float> normals;                  ///< x y z, unit
  std::span<const float> texture_coords;           ///< u v, or empty
  std::span<const float> colors;                   ///< linear r g b a, or empty: white
  std::span<const std::uint8_t> regions;           ///< tint region 0..4 a vertex, or empty: untinted
  std::span<const std::uint16_t> palette_entries;  ///< four a vertex
  std::span<const float> weights;                  ///< four a vertex, sum 1
  std::span<const std::uint32_t> indices;          ///< triangles, counter-clockwise front
  int material = 0;
};

struct MaterialData {
  float base_color[4] = {1, 1, 1, 1};  ///< linear
  int image = -1;
  bool double_sided = false;
  float alpha_cutoff = 0.0F;
};

struct ImageData {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba;  ///< sRGB, top row first
};

struct CrowdMeshData {
  std::vector<MeshPartData> parts;
  std::vector<MaterialData> materials;
  std::vector<ImageData> images;
  /// For each bone level, entry -> entry that a vertex reads at that level (itself where kept, else the one of the
  /// nearest kept ancestor); [0] is the identity. 1 to 4 levels.
  std::vector<std::vector<std::uint16_t>> entry_at_level;
};

}  // namespace throng::render
