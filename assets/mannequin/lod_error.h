#pragma once

#include <span>

#include "assets/mannequin/clip.h"
#include "assets/mannequin/mesh.h"

namespace throng::mannequin {

/// How far two surfaces are apart, metres.
struct SurfaceError {
  double largest = 0;
  double mean = 0;
};

/// From the vertices of each mesh to the nearest place of the other, both skinned, over keys of all clips. A vertex
/// looks for that place among triangles that are near it at rest.
SurfaceError surface_error(const Mesh& full, const Mesh& coarse, std::span<const Clip> clips);

}  // namespace throng::mannequin
