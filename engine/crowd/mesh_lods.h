#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "throng/render/mesh_error_value.h"
#include "throng/view_rules.h"

namespace throng {

/// Returns the errors in metres as shares of a character's height.
render::MeshError shares_of(const render::MeshError& metres, double height);
/// Returns the height on screen, in pixels, below which a mesh with that error is fine enough; infinity without error.
/// `shares` are of the character's height.
float fine_below(const render::MeshError& shares, const MeshTolerance& tolerance);

/// Chooses the mesh LOD of each agent by the error that it shows on screen. A mesh LOD depends on no bone level.
class MeshLods {
 public:
  explicit MeshLods(std::size_t characters) : shares_(characters), triangles_(characters) {}

  /// Takes the errors of a character's mesh LODs, the full mesh first, in shares of the character's height, and their
  /// numbers of triangles.
  void set(std::size_t character, std::vector<render::MeshError> shares, std::vector<std::uint32_t> triangles) {
    shares_[character] = std::move(shares);
    triangles_[character] = std::move(triangles);
  }

  /// Returns the coarsest LOD within the limit for a character of that height on screen, or the LOD that the rules
  /// fix. 0 for a character without LODs.
  int choose(const MeshRules& rules, std::uint8_t character, float pixels_tall) const;
  /// Returns how much is seen of a LOD that is coarser than choose() takes: the pixels that surface and face are off,
  /// and more where an agent loses the face that it should keep.
  float seen_px(const MeshRules& rules, std::uint8_t character, int lod, float pixels_tall) const;
  /// Returns the pixels that the surface of a LOD is off.
  float error_px(std::uint8_t character, int lod, float pixels_tall) const;
  /// Returns the first mesh LOD that no agent of the first `people` characters shows while taller than `pixels_tall`,
  /// as far as errors decide; `lods` if there is none.
  std::size_t first_below(const MeshRules& rules, std::size_t people, float pixels_tall, std::size_t lods) const;
  /// Returns the errors of a character's mesh LODs, as they were set.
  std::span<const render::MeshError> shares(std::size_t character) const { return shares_[character]; }
  /// Returns the triangles of a character's mesh LODs, as they were set.
  std::span<const std::uint32_t> triangles(std::size_t character) const { return triangles_[character]; }

 private:
  std::vector<std::vector<render::MeshError>> shares_;  // [character][LOD]
  std::vector<std::vector<std::uint32_t>> triangles_;   // [character][LOD]
};

}  // namespace throng
