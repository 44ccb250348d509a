#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assets/wardrobe/finish.h"

namespace throng::wardrobe {

/// Metres that one step of a position is as written; the inverse bind matrices of the file's skin scale by it.
inline constexpr double written_step = 1.0 / 16384;

/// Returns the wardrobe as a binary glTF 2.0 file (assets/README.md, "The wardrobe").
std::vector<std::byte> write_wardrobe(std::span<const Finished> parts);

/// The whole file, from scratch.
std::vector<std::byte> make_wardrobe();

}  // namespace throng::wardrobe
