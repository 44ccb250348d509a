#pragma once

#include <algorithm>
#include <cstdint>

#include "app/people/wardrobe/wardrobe.h"

namespace throng::app {

/// Returns the part that a piece of the wardrobe shows, also below another part.
inline const WardrobePart& part_of_piece(const Wardrobe& wardrobe, std::uint16_t piece) {
  return *std::ranges::find_if(wardrobe.parts(), [&](const WardrobePart& part) {
    return part.piece == piece || std::ranges::find(part.below, piece, &PieceBelow::piece) != part.below.end();
  });
}

}  // namespace throng::app
