#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "throng/render/crowd_mesh_data.h"

namespace throng::render {

/// The effect of a morph on a vertex, as `shaders/morphs.glsl` reads it.
///
///      0  morph             its place among the weights of the instance
///      4  position x y z    added to the vertex in the bind pose, times the weight
///     16  normal x y z      added to the normal
struct MorphEntry {
  std::uint32_t morph;
  float position[3];
  float normal[3];
};
static_assert(sizeof(MorphEntry) == 28);
static_assert(offsetof(MorphEntry, normal) == 16);

/// The entries of each vertex, one after the other: vertex v has `entries` from firsts[v] to firsts[v + 1].
struct MorphTable {
  std::vector<std::uint32_t> firsts;  ///< one more than vertices
  std::vector<MorphEntry> entries;
};

/// Makes the table of a surface. It asserts that `deltas` ascend by vertex, and that there are such vertices.
MorphTable build_morph_table(std::span<const MorphDeltaData> deltas, std::size_t vertex_count);

}  // namespace throng::render
