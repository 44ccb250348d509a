#pragma once

#include <cstddef>
#include <new>
#include <span>

#include "engine/anim/entity/entity_kind.h"

namespace throng::anim {

/// One source of each entity of a run: their states, in even steps, and what they show, side by side.
struct SourceRow {
  const std::byte* first;
  std::size_t stride;       ///< bytes to the state of the next entity's; 0: all read the same
  const ShownClips* shown;  ///< null where nobody asks
};

/// What the sources of one entity of a run are, in the order of EntityKind::sources.
class SourcesInStore {
 public:
  SourcesInStore(std::span<const SourceRow> rows, std::size_t entity) : rows_(rows), entity_(entity) {}

  std::size_t size() const { return rows_.size(); }
  bool empty() const { return rows_.empty(); }
  const AnimationStateHeader& operator[](std::size_t source) const {
    return *reinterpret_cast<const AnimationStateHeader*>(rows_[source].first + entity_ * rows_[source].stride);
  }
  const ShownClips& shown(std::size_t source) const { return rows_[source].shown[entity_]; }

 private:
  std::span<const SourceRow> rows_;
  std::size_t entity_;
};

/// Entities of one kind and as many sources, each of another character, in even steps through a local store.
struct EntityRun {
  EntityInStore first;
  std::size_t count = 1;
  std::size_t block_stride = 0;     ///< bytes to the next entity's block
  std::size_t prepared_stride = 0;  ///< and to what is prepared for it
  std::span<const SourceRow> sources{};
  const Ticks* deltas = nullptr;  ///< [count] that pass for each first; null: delta times are there already
  /// [count] out: what each shows where that is a clip, or a blend of two, since kernels make such poses for many
  /// characters at once. Null: nobody asks, poses are made packet by packet.
  ShownClips* shown = nullptr;

  EntityInStore entity(std::size_t index) const {
    return {.block = first.block + index * block_stride,
            .prepared = first.prepared + index * prepared_stride,
            .layout = first.layout,
            .assets = first.assets};
  }
  SourcesInStore sources_of(std::size_t index) const { return {sources, index}; }
};

using AdvanceEntity = void (*)(const EntityInStore& entity, const SourcesInStore& sources);
using ShowClips = ShownClips (*)(const EntityInStore& entity, const SourcesInStore& sources);

/// EntityKind::advance by what advances one entity and, where its pose may be clips alone, what then says which: those
/// that pose_packet would show. Both are known here and lie in the loop, where calls would take as long as what they
/// do, and where a delta time need not be in memory to be used up.
template <AdvanceEntity advance, ShowClips show = nullptr>
void advance_each(const EntityRun& shared) {
  const EntityRun run = shared;  // or it would be read again after every store
  for (std::size_t i = 0; i < run.count; ++i) {
    const EntityInStore entity = run.entity(i);
    const SourcesInStore sources = run.sources_of(i);
    if (run.deltas != nullptr) entity.as<AnimationStateHeader>().delta_time += run.deltas[i];
    advance(entity, sources);
    if (run.shown == nullptr) continue;
    if constexpr (show == nullptr) {
      run.shown[i].clip = run.shown[i].blended = nullptr;
    } else {
      // Made in its place: a copy would wait for the parts that were just written.
      ::new (&run.shown[i]) ShownClips(show(entity, sources));
    }
  }
}

}  // namespace throng::anim
