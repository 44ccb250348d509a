#pragma once

#include <cstddef>

#include "assets/mannequin/cage.h"

namespace throng::mannequin {

/// Sets an almond with lashes and a dark iris into the quad of the left eye's socket, and the eyebrow above it.
void add_eye_and_brow(Cage& cage, std::size_t socket);

/// Sets a flat ring into the patch behind the temple, which keeps the cheek even, and on it a rim that stands off.
void add_ear(Cage& cage, std::size_t patch);

/// Tints the quad between the middle and the left corner of the mouth, the upper lip darker.
void paint_lips(Cage& cage, std::size_t lips);

}  // namespace throng::mannequin
