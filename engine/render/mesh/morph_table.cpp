#include "engine/render/mesh/morph_table.h"

#include <algorithm>
#include <cassert>

namespace throng::render {

MorphTable build_morph_table(std::span<const MorphDeltaData> deltas, std::size_t vertex_count) {
  assert(std::ranges::is_sorted(deltas, {}, &MorphDeltaData::vertex));
  assert(deltas.empty() || deltas.back().vertex < vertex_count);
  MorphTable table;
  table.firsts.assign(vertex_count + 1, 0);
  table.entries.reserve(deltas.size());
  for (const MorphDeltaData& delta : deltas) {
    ++table.firsts[delta.vertex + 1];
    MorphEntry& entry = table.entries.emplace_back();
    entry.morph = delta.morph;
    std::ranges::copy(delta.position, entry.position);
    std::ranges::copy(delta.normal, entry.normal);
  }
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) table.firsts[vertex + 1] += table.firsts[vertex];
  return table;
}

}  // namespace throng::render
