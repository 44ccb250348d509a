#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assets/mannequin/clip.h"
#include "assets/mannequin/mesh.h"

namespace throng::mannequin {

/// The character as a binary glTF 2.0 file: one mesh of one primitive, one skin, the clips.
std::vector<std::byte> write_glb(const Mesh& mesh, std::span<const Clip> clips);

/// The skinned body at rest.
Mesh make_body();

/// The whole file, from scratch.
std::vector<std::byte> make_mannequin();

}  // namespace throng::mannequin
