#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace throng::render {

/// Plain data in, by which app/ hands a character's surface to drawing. All spans of one part have `vertex_count`
/// elements.
struct MeshPartData {
  std::span<const float> positions;                ///< x y z, in the space of the palette
  std::span<const float> normals;                  ///< x y z, unit
  std::span<const float> texture_coords;           ///< u v, or empty
  std::span<const float> colors;                   ///< linear r g b a, or empty: white
  std::span<const std::uint8_t> regions;           ///< tint region 0..4 a vertex, or empty: untinted; so are others
  std::span<const float> shapes;                   ///< three a vertex, -1..1, or empty: see SurfaceVertex
  std::span<const float> hair;                     ///< two a vertex, -1..1, or empty
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

/// One end of a bone's line: where the joint is at rest, in the space of the palette, and the entry that moves it.
struct BoneEndData {
  float position[3] = {0, 0, 0};
  std::uint16_t palette_entry = 0;
};

/// What it takes to unpack a palette entry (shaders/skinning.glsl): where its joint rests, in the space of the palette,
/// and the length of a unit of its position, in metres.
struct PackingFrameData {
  float pivot[3] = {0, 0, 0};
  float step = 0;
};

/// A coarser surface that came with the character.
struct BakedLodData {
  std::vector<MeshPartData> parts;
  float error = 0.0F;  ///< metres
};

struct CrowdMeshData {
  std::vector<MeshPartData> parts;
  std::vector<BakedLodData> baked_lods;  ///< finest first, used instead of simplifying `parts`; or empty
  std::vector<MaterialData> materials;
  std::vector<ImageData> images;
  /// For each bone level, entry -> entry that a vertex reads at that level (itself where kept, else the one of the
  /// nearest kept ancestor); [0] is the identity. 1 to 4 levels.
  std::vector<std::vector<std::uint16_t>> entry_at_level;
  std::vector<PackingFrameData> packing_frames;  ///< one a palette entry; or empty: no slot of it is ever packed
  std::vector<BoneEndData> bone_ends;  ///< two a bone, joint and parent, for CrowdFrame::bones_as_lines; or empty
};

}  // namespace throng::render
