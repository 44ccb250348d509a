#pragma once

#include <array>
#include <vector>

#include "assets/mannequin/cage.h"

namespace throng::mannequin {

struct Quad {
  std::array<std::size_t, 4> corners;  ///< Counter-clockwise seen from outside.
  Region region;
  glm::dvec3 paint;
  FaceNotes notes = {};
};

/// A quad mesh, one vertex per position.
struct Surface {
  std::vector<CageVertex> vertices;
  std::vector<Quad> quads;
};

/// One step of Catmull-Clark subdivision (Catmull and Clark 1978) of a cage, weights and paint included.
/// Open borders become the curves of their own vertices.
Surface subdivide(const Cage& cage);

/// Moves the cage's vertices until the subdivided surface passes near the places where they were authored.
Cage fit(const Cage& authored, int rounds);

}  // namespace throng::mannequin
