#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assets/places/finished_mesh.h"

namespace throng::places {

/// Returns the props as a binary glTF 2.0 file: a mesh for each level of each prop, which share vertices.
std::vector<std::byte> write_glb(std::span<const MadeMesh> meshes);

/// The whole file, from scratch.
std::vector<std::byte> make_places();

}  // namespace throng::places
