#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assets/mannequin/body.h"
#include "assets/mannequin/clip.h"

namespace throng::mannequin {

inline constexpr double error_step = 1.0 / 1024;  ///< Metres, of the LODs' errors as written, rounded up.

/// The character as a binary glTF 2.0 file: one skin, a mesh of one primitive for every LOD, the clips. The default
/// scene shows the full mesh alone; those of the LODs are in a second scene, and the full mesh's node names their
/// nodes.
std::vector<std::byte> write_glb(const Body& body, std::span<const Clip> clips);

/// The whole file, from scratch.
std::vector<std::byte> make_mannequin();

}  // namespace throng::mannequin
