#pragma once

#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::import {

/// add_tangents() takes at most so many bytes for each index and vertex, besides the mesh once more.
inline constexpr std::size_t bytes_of_tangents = 16 * sizeof(double);

// These functions let light fall on the right side of a mesh. All of them take a mesh with its influences.

/// Gives every triangle normals of its own, by copies of the vertices that it shares, which come last (glTF 2.0,
/// 3.7.2.1: without normals flat normals, and no tangents of the file).
void shade_flat(anim::SkinnedMesh& mesh);

/// Says of each palette entry whether it mirrors its vertices in the rest pose.
std::vector<bool> mirrored_entries(const anim::Skeleton& skeleton);

/// Turns the triangles over that the palette mirrors, so that their front is counter-clockwise once they are drawn.
void turn_mirrored_triangles(anim::SkinnedMesh& mesh, const std::vector<bool>& mirrored_entries);

/// Adds tangents along the normal texture's u axis if the material has such a texture, and the mesh its coordinates.
/// Triangles add to their corners as in MikkTSpace. Vertices where a texture meets its mirror image become two.
void add_tangents(anim::SkinnedMesh& mesh, const anim::Material& material);

}  // namespace throng::import
