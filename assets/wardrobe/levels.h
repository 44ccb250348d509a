#pragma once

#include <span>
#include <vector>

#include "assets/wardrobe/finish.h"

namespace throng::wardrobe {

/// The coarsest meshes over a mesh's vertices whose errors, over poses of the clips, stay within `bounds`.
/// Borders of regions and pieces stay sharp, and open borders are held.
std::vector<Level> coarser_levels(const mannequin::Mesh& mesh, std::span<const double> bounds);

/// Meshes of about so many triangles, for people far away, with their errors.
std::vector<Level> levels_of_size(const mannequin::Mesh& mesh, std::span<const std::size_t> triangles);

/// The triangles of a mesh as a level.
Level whole_level(const mannequin::Mesh& mesh);

}  // namespace throng::wardrobe
