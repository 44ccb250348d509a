#pragma once

#include <span>
#include <string>
#include <vector>

#include "assets/wardrobe/finish.h"

namespace throng::wardrobe {

/// Triangles of a silhouette's three levels, which stand for mesh LOD 4 to 6.
inline constexpr std::array<std::size_t, 3> silhouette_sizes{220, 130, 82};

/// The names of the parts that silhouettes are joined of.
std::vector<std::string> silhouette_parts();

/// Whole outfits joined and made coarse, for people far away: one a kind of bottom and a kind of hair, on all bodies.
std::vector<Finished> make_silhouettes(std::span<const Finished> parts);

}  // namespace throng::wardrobe
