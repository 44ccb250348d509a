#include "app/show/picture.h"

#include <algorithm>

#include "app/settings/agent_colors.h"

namespace throng::app {
namespace {

constexpr std::uint32_t lods = mesh_lod_steps;

}  // namespace

void Picture::compose(const Stage& stage, Poses poses) {
  entries_.clear();
  morphs_.clear();
  const auto characters = static_cast<std::uint32_t>(stage.characters().size());
  const bool morphs = std::ranges::any_of(
      stage.characters(), [](const CharacterSource& source) { return !source.character->morph_bones.empty(); });
  const bool lod_as_color = stage.tuning().debug_view == DebugView::mesh_lod;
  const std::span<const anim::VisibleAgent> visible = stage.selection().visible;
  for (std::size_t at = 0; at < visible.size(); ++at) {
    const anim::VisibleAgent& agent = visible[at];
    Entry entry;
    if (!stage.record(agent, entry.record, poses)) continue;
    if (morphs) morphs_.add(stage, agent, entry.record);
    const ShownPose& pose = stage.pose_of(agent.agent, poses);
    const std::uint8_t character = stage.crowd().characters()[agent.agent];
    const int lod = poses == Poses::exact ? 0 : mesh_choice_of(stage).lods()[at];
    entry.run = (pose.to.page * characters + character) * lods + static_cast<std::uint32_t>(lod);
    if (lod_as_color && agent.agent != stage.selected())
      entry.record.debug_color = debug_color(DebugView::mesh_lod, {.mesh_lod = lod});
    entries_.push_back(entry);
  }
  sort_into_runs(characters);
}

// A counting sort, stable, so that equal frames give equal pictures.
void Picture::sort_into_runs(std::uint32_t characters) {
  std::uint32_t runs = 0;
  for (const Entry& entry : entries_) runs = std::max(runs, entry.run + 1);
  run_starts_.assign(runs + 1, 0);
  for (const Entry& entry : entries_) ++run_starts_[entry.run + 1];
  batches_.clear();
  for (std::uint32_t run = 0; run < runs; ++run) {
    const std::uint32_t count = run_starts_[run + 1];
    run_starts_[run + 1] += run_starts_[run];
    if (count == 0) continue;
    batches_.push_back({.page = run / lods / characters,
                        .character = static_cast<std::uint8_t>(run / lods % characters),
                        .mesh_lod = static_cast<std::uint8_t>(run % lods),
                        .first_instance = run_starts_[run],
                        .instance_count = count});
  }
  instances_.resize(entries_.size());
  for (const Entry& entry : entries_) instances_[run_starts_[entry.run]++] = entry.record;
}

}  // namespace throng::app
