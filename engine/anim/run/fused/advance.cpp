#include "engine/anim/run/fused/advance.h"

#include <algorithm>
#include <array>

namespace throng::anim {
namespace {

/// Shared entities are poses that lie there already.
constexpr std::array<ShownClips, most_characters> no_clips{};

void advance_run(const TileInStore& tile, const AgentRun& run, StepCursor cursor, const ShownBySteps& shown,
                 const Ticks* deltas) {
  const PoseProgram& program = *run.program;
  const std::size_t root = program.steps.size() - 1;
  LeftBySteps<SourceRow> rows;
  std::array<SourceRow, max_sources> sources;
  for_each_shared(program, [&](std::size_t i, const PoseStep& step) {
    if (i == root) std::ranges::fill(shown.last.subspan(run.first, run.count), ShownClips{});
    rows.left[i] = {reinterpret_cast<const std::byte*>(&tile.shared_state(step.shared)), 0, no_clips.data()};
  });
  std::size_t own_step = 0;
  for_each_own(*tile.context, program, cursor, root + 1,
               [&](std::size_t i, const PoseStep& step, const EntityInStore& entity) {
                 const std::span<ShownClips> row =
                     i == root ? shown.last.subspan(run.first, run.count) : shown.row(own_step, run);
                 ++own_step;
                 const bool asked = !entity.layout->is_resident();
                 if (!asked) std::ranges::fill(row, ShownClips{});
                 const EntityRun entities{.first = entity,
                                          .count = run.count,
                                          .block_stride = program.needs.fetch_bytes,
                                          .prepared_stride = program.needs.prepared_bytes,
                                          .sources = rows.sources(step, sources),
                                          .deltas = deltas + run.first,
                                          .shown = asked ? row.data() : nullptr};
                 entity.layout->kind->advance(entities);
                 rows.left[i] = {entity.block, entities.block_stride, row.data()};
               });
}

}  // namespace

void advance_entities(const TileInStore& tile, StepCursor first, TileLists& lists) {
  for (std::size_t i = 0; i < tile.work.size(); ++i) lists.deltas[i] = tile.work[i].delta;
  const ShownBySteps shown = lists.shown_by(tile.work.size());
  for (const AgentRun& run : tile.runs) {
    advance_run(tile, run, first, shown, lists.deltas.data());
    first = first.of_next(*run.program, run.count);
  }
}

}  // namespace throng::anim
