#pragma once

#include <cstddef>
#include <new>
#include <span>

#include "engine/anim/entity/entity_kind.h"

namespace throng::anim {

/// One source of each entity of a run. Their states lie in even steps, their shown clips side by side.
struct SourceRow {
  const std::byte* first;
  std::size_t stride;       ///< bytes to the source of the next entity; 0: all entities read the same source
  const ShownClips* shown;  ///< null where no entity asks for clips
};

/// The sources of one entity of a run, in the order of EntityKind::sources.
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

/// Entities of one kind, one a character, that have equally many sources and lie in even steps in a local store.
struct EntityRun {
  EntityInStore first;
  std::size_t count = 1;
  std::size_t block_stride = 0;     ///< bytes to the next entity's block
  std::size_t prepared_stride = 0;  ///< bytes to the next entity's prepared scratch
  std::span<const SourceRow> sources{};
  const Ticks* deltas = nullptr;  ///< [count] added to each delta time first; null: delta times are complete
  /// [count] out: the clip that each entity shows, or the blend of two. Kernels pose these for many characters at once.
  /// Null: poses are made packet by packet.
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

/// Makes an EntityKind::advance of a function that advances one entity. `show`, for kinds whose pose may be clips
/// alone, returns the clips that pose_packet would show. Both are template arguments, so that the compiler inlines
/// them: a call takes as long as their work.
template <AdvanceEntity advance, ShowClips show = nullptr>
void advance_each(const EntityRun& shared) {
  const EntityRun run = shared;  // a copy, since the compiler reads the original again after every store
  for (std::size_t i = 0; i < run.count; ++i) {
    const EntityInStore entity = run.entity(i);
    const SourcesInStore sources = run.sources_of(i);
    if (run.deltas != nullptr) entity.as<AnimationStateHeader>().delta_time += run.deltas[i];
    advance(entity, sources);
    if (run.shown == nullptr) continue;
    if constexpr (show == nullptr) {
      run.shown[i].clip = run.shown[i].blended = nullptr;
    } else {
      // Constructed in place, since a copy waits for the parts that were just written.
      ::new (&run.shown[i]) ShownClips(show(entity, sources));
    }
  }
}

}  // namespace throng::anim
