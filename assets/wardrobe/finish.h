#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "assets/mannequin/mesh.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

inline constexpr std::size_t near_levels = 4;
/// Levels 1 to 3 are off by so many metres at most.
inline constexpr std::array<double, near_levels - 1> level_bounds{0.012, 0.022, 0.052};

/// Triangles over the vertices of level 0.
struct Level {
  std::vector<std::uint16_t> indices;
  double error = 0;
};

/// The triangles of a part that are seen below outer clothes of a tag.
struct Below {
  std::string tag;
  std::vector<Level> levels;  ///< as many as the part has
};

/// A part before it is warped: vertices where the man rests, and its levels, which all bodies share.
struct MadePart {
  std::string name;
  Slot slot;
  const Part* part = nullptr;  ///< Null for a piece of skin.
  mannequin::Mesh mesh;        ///< Of the man; `openness` is not in its colours.
  std::vector<Level> levels;   ///< Level 0 first.
  std::vector<Below> below = {};
};

/// A part on a body: what differs between bodies, one a vertex of the part's mesh.
struct Fitted {
  Body body;
  std::vector<glm::dvec3> positions, normals;
  std::vector<std::array<std::uint8_t, 4>> colours;
};

struct Finished {
  std::shared_ptr<MadePart> made;
  std::vector<Fitted> bodies;
};

/// The bodies' pieces, then all parts, finished; `only` names the parts that are wanted, or is empty.
/// Without `with_levels` all have level 0 alone, which is quick.
std::vector<Finished> finish_wardrobe(const std::vector<std::string>& only, bool with_levels);

/// Fills MadePart::below of the tops among the parts: what all outer clothes of a tag hide is left out. Cloth that is
/// worn below other cloth then cannot come through it.
void find_seen_below(std::span<const Finished> parts);

}  // namespace throng::wardrobe
