#pragma once

#include <span>
#include <string>
#include <vector>

#include "assets/wardrobe/finish.h"
#include "assets/wardrobe/levels.h"

namespace throng::wardrobe {

/// Bounds of a silhouette's three levels, which stand for mesh LOD 4 to 6. All silhouettes are off by the same, because
/// the worst one says when a whole crowd goes over to them.
inline constexpr std::array<FarBound, 3> silhouette_levels{{{0.076, 300}, {0.125, 170}, {0.190, 110}}};

/// The names of the parts that silhouettes are joined of.
std::vector<std::string> silhouette_parts();

/// Whole outfits joined and made coarse, for people far away: one a kind of bottom and a kind of hair, on all bodies.
std::vector<Finished> make_silhouettes(std::span<const Finished> parts);

}  // namespace throng::wardrobe
