#pragma once

#include <array>
#include <cstddef>

#include "assets/mannequin/mesh.h"

namespace throng::mannequin {

inline constexpr std::size_t mesh_lod_count = 3;

/// The body and its three coarser LODs, each finer one first: about 1,500, 500 and 150 triangles.
struct Body {
  Mesh full;
  std::array<Mesh, mesh_lod_count> lods;
};

Body make_body();

/// Whether a joint is among those that import keeps at a bone level, 0 to 2. LOD n is skinned to the joints of level n
/// or, beyond the last, of the last.
bool kept_at_level(std::size_t joint, std::size_t level);

/// The body in about 500 triangles, its points on or near `full`, from which they take weights and shading.
Skin make_medium_skin(const Skin& full);
/// The same in about 150.
Skin make_smallest_skin(const Skin& full);

}  // namespace throng::mannequin
