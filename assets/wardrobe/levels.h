#pragma once

#include <span>
#include <vector>

#include "assets/wardrobe/finish.h"

namespace throng::wardrobe {

/// Says of each vertex of a mesh whether it stays where it is at every level; empty: none has to.
using Held = std::vector<bool>;

/// The mesh without the points that lie within less than a millimetre of a plane surface.
Level finest_level(const mannequin::Mesh& mesh, const Held& held = {});

/// The coarsest meshes over a mesh's vertices whose errors, over poses of the clips, stay within `bounds`.
/// Borders of regions and pieces stay sharp, and open borders are held. Trims stay sharp at the first level only,
/// which has no more triangles than `finest`.
std::vector<Level> coarser_levels(const mannequin::Mesh& mesh, std::span<const double> bounds, const Level& finest,
                                  const Held& held = {});

/// Says how coarse a mesh for people far away may be.
struct FarBound {
  double error;           ///< metres by which it may be off the mesh
  std::size_t triangles;  ///< the most that it has, even where that puts it further off
};
/// Returns the coarsest meshes within bounds. Of several ways to merge points, each level takes the one that needs the
/// fewest triangles, or else the one that is off the least.
std::vector<Level> far_levels(const mannequin::Mesh& mesh, std::span<const FarBound> bounds);

/// Drops the vertices that no level uses. Returns the old numbers of those that stay.
std::vector<std::size_t> keep_used(mannequin::Mesh& mesh, std::vector<Level>& levels);

/// The triangles of a mesh as a level.
Level whole_level(const mannequin::Mesh& mesh);

}  // namespace throng::wardrobe
