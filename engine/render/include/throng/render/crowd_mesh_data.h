#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x3.hpp>

#include "throng/render/crowd_batch.h"

namespace throng::render {

/// Hands a part of a character's surface to drawing, as plain data. All spans except `indices` describe the
/// same number of vertices.
struct MeshPartData {
  std::span<const float> positions;        ///< x y z, in the space of the palette
  std::span<const float> normals;          ///< x y z, unit
  std::span<const float> texture_coords;   ///< u v of the base colour, or empty; without a texture, of patterns: metres
  std::span<const float> emission_coords;  ///< u v of the emission, or empty: `texture_coords`; so are these
  std::span<const float> metallic_roughness_coords;
  std::span<const float> normal_coords;
  std::span<const float> occlusion_coords;
  std::span<const float> tangents;                 ///< x y z, unit, and the side of the bitangent; or empty: no bumps
  std::span<const float> colors;                   ///< linear r g b a, or empty: white
  std::span<const std::uint8_t> regions;           ///< Region a vertex; any other, or empty: untinted
  std::span<const float> shapes;                   ///< three a vertex, -1..1, or empty: see SurfaceVertex
  std::span<const float> hair;                     ///< two a vertex, -1..1, or empty
  std::span<const float> trims = {};               ///< one a vertex, 0..1, or empty: where Pattern::trim shows
  std::span<const float> faces = {};               ///< four a vertex, -1..1, or empty: see SurfaceVertex
  std::span<const std::uint16_t> palette_entries;  ///< four a vertex
  std::span<const float> weights;                  ///< four a vertex, sum 1
  std::span<const std::uint32_t> indices;          ///< triangles, counter-clockwise front
  int material = 0;
};

/// An image as a material shows it, or as it reads numbers from it. Wraps and filters have OpenGL's numbers, which glTF
/// shares.
struct TextureData {
  int image = -1;        ///< index among CrowdMeshData::images; -1: plain white
  int wrap_u = 10497;    ///< GL_REPEAT
  int wrap_v = 10497;    ///< GL_REPEAT
  int magnified = 9729;  ///< GL_LINEAR
  int minified = 9987;   ///< GL_LINEAR_MIPMAP_LINEAR
};

/// Describes a material as glTF 2.0 does. Factors multiply what their textures hold.
struct MaterialData {
  float base_color[4] = {1, 1, 1, 1};  ///< linear
  TextureData base_color_texture;
  float emission[3] = {0, 0, 0};  ///< linear, 1: white of the screen
  TextureData emission_texture;
  float metallic = 0.0F;
  float roughness = 1.0F;
  TextureData metallic_roughness_texture;  ///< roughness in green, metallic in blue
  float normal_scale = 1.0F;
  TextureData normal_texture;
  float occlusion_strength = 1.0F;
  TextureData occlusion_texture;  ///< in red
  bool unlit = false;             ///< shows its base colour, whatever the light
  bool double_sided = false;
  bool blended = false;       ///< it is seen through as far as its alpha is below 1
  float alpha_cutoff = 0.0F;  ///< less alpha is not seen
};

struct ImageData {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba;  ///< top row first; sRGB where it is a colour, linear where it holds numbers
};

/// Describes one end of a bone's line: the place of the joint at rest, in the space of the palette, and the palette
/// entry that moves it.
struct BoneEndData {
  float position[3] = {0, 0, 0};
  std::uint16_t palette_entry = 0;
};

/// Unpacks a palette entry (shaders/palette/packed_palette.glsl): `pivot` is where its joint rests, in the space of the
/// palette, and `step` is the length in metres of one unit of its position.
struct PackingFrameData {
  float pivot[3] = {0, 0, 0};
  float step = 0;
};

/// Holds the change that a morph of weight 1 makes to a vertex of the full surface, in the space of the palette.
struct MorphDeltaData {
  std::uint32_t vertex = 0;  ///< counted over all `parts`
  std::uint32_t morph = 0;   ///< its place among the weights of an instance
  float position[3] = {0, 0, 0};
  float normal[3] = {0, 0, 0};
};

/// The most mesh LODs that a character has, its full surface included.
inline constexpr std::size_t largest_mesh_lod_count = 7;

/// A coarser surface that comes with the character.
struct BakedLodData {
  std::vector<MeshPartData> parts;
};

/// A mesh of a piece at one level.
struct PieceLevelData {
  std::vector<MeshPartData> parts;
  float error = 0.0F;  ///< metres that it is off; 0 for the finest of a usual piece
};

/// A piece of a character that some agents wear (Outfit).
struct MeshPieceData {
  /// Finest first, at least one. The levels of a usual piece stand for mesh LODs from 0 on, the levels of a silhouette
  /// for mesh LODs from first_silhouette_lod on; the last level stands for all that follow. A single level is
  /// simplified, unless it is a silhouette's.
  std::vector<PieceLevelData> levels;
  bool is_silhouette = false;
};

/// Palettes of poses that stand for all that a character does: [pose][entry].
using PosedPalettes = std::vector<std::vector<glm::mat4x3>>;

struct CrowdMeshData {
  std::vector<MeshPartData> parts;       ///< piece 0, all of a character; agents without an outfit are drawn with it
  std::vector<BakedLodData> baked_lods;  ///< finest first, the first few are used; if empty, `parts` are simplified
  std::vector<MeshPieceData> pieces;     ///< pieces 1, 2 ...: agents with an outfit wear them
  std::vector<MaterialData> materials;
  std::vector<ImageData> images;
  /// Maps, for each of 1 to 4 bone levels, a palette entry to the entry that a vertex reads at that level: itself where
  /// the bone is kept, else the entry of its nearest kept ancestor. [0] is the identity.
  std::vector<std::vector<std::uint16_t>> entry_at_level;
  std::vector<std::uint8_t> face_entries;  ///< one a palette entry, 1: it moves a face; or empty: no face is known
  std::vector<PackingFrameData> packing_frames;  ///< one a palette entry; empty if no slot is ever packed
  std::vector<MorphDeltaData> morph_deltas;      ///< ascending by vertex; empty: the surface does not morph
  PosedPalettes poses;                           ///< the rest pose first; mesh LODs are measured in them
  float body_size = 1.0F;  ///< over a person's; differences of bodies (SurfaceVertex::shape) reach as much farther
  std::vector<BoneEndData> bone_ends;  ///< joint and parent of each bone, for CrowdFrame::bones_as_lines; or empty
  /// A surface that pack_surface made of all this. Where it is given, LODs, poses and bone ends are not read.
  std::span<const std::byte> packed_surface;
};

}  // namespace throng::render
