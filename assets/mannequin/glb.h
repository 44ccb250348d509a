#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assets/mannequin/body.h"
#include "assets/mannequin/clip.h"

namespace throng::mannequin {

/// Returns the character as a binary glTF 2.0 file: one skin, one mesh of one primitive, the clips.
std::vector<std::byte> write_glb(const Mesh& body, std::span<const Clip> clips);

/// The whole file, from scratch.
std::vector<std::byte> make_mannequin();

}  // namespace throng::mannequin
