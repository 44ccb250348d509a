#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "assets/places/props.h"

namespace throng::places {

/// One vertex as it is written.
struct MadeVertex {
  std::array<std::int16_t, 3> position;  ///< times the mesh's step
  std::array<std::int8_t, 3> normal;     ///< by 127
  std::array<std::uint8_t, 4> colour;    ///< linear; alpha is 255
  std::array<std::uint8_t, 4> surface;   ///< glow, tinted, sway, kind
  friend bool operator<(const MadeVertex& a, const MadeVertex& b) {
    return std::tie(a.position, a.normal, a.colour, a.surface) < std::tie(b.position, b.normal, b.colour, b.surface);
  }
};

struct MadeLevel {
  std::vector<std::uint16_t> indices = {};
  double error = 0;
};

/// A prop with all its levels, which share its vertices.
struct MadeMesh {
  std::string name;
  double step = 0;  ///< metres a unit of a position: a power of two
  std::vector<MadeVertex> vertices = {};
  std::vector<MadeLevel> levels = {};
};

MadeMesh finish(const Prop& prop);

}  // namespace throng::places
