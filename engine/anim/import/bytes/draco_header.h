#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace throng::import {

/// Holds the numbers of triangles and points that the head of a Draco mesh states.
struct DracoCounts {
  std::uint64_t faces = 0;
  std::uint64_t points = 0;  ///< of the connectivity; seams add points
  std::uint64_t seams = 0;   ///< tables of corners beside the faces' table
  bool by_valence = false;   ///< whether the walk keeps lists of the faces by the valence of their corners
};

/// Reads the head of a Draco mesh of version 2.2, the only one that glTF allows. Throws Refusal.
DracoCounts read_draco_counts(std::span<const std::byte> bytes);

}  // namespace throng::import
