#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "assets/making/buffer_writer.h"
#include "assets/mannequin/body.h"
#include "assets/mannequin/clip.h"

namespace throng::mannequin {

/// Returns the nodes of the skeleton, the root first.
making::Json joint_nodes();

/// Returns a matrix a joint that takes its place at rest away: a translation, by what the rounded nodes add up to.
std::vector<std::array<float, 16>> inverse_binds();

/// Returns a character of the skeleton as a binary glTF 2.0 file: one skin, one mesh of one primitive, the clips. Skin,
/// mesh and material have its name.
std::vector<std::byte> write_glb(const Mesh& body, std::span<const Clip> clips, const std::string& name = "mannequin");

/// The whole file, from scratch.
std::vector<std::byte> make_mannequin();

}  // namespace throng::mannequin
