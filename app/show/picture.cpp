#include "app/show/picture.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "app/settings/agent_colors.h"
#include "engine/anim/base/run_jobs.h"

namespace throng::app {
namespace {

constexpr std::uint32_t lods = mesh_lod_steps;
constexpr std::uint32_t not_drawn = UINT32_MAX;
constexpr std::size_t agents_worth_a_job = 1024;
constexpr std::size_t runs_a_line = 64 / sizeof(std::uint32_t);  // of the cache
constexpr std::uint32_t bits_below_weights = 16;

/// Calls visit(tile) for each tile, on the PUs of a stage.
template <typename Tile, typename Visit>
void visit_on_pus(const Stage& stage, std::span<Tile> tiles, Visit visit) {
  anim::run_jobs(stage.system().executor(), tiles.size(), [&](std::size_t tile) { visit(tiles[tile]); });
}

}  // namespace

/// All that the tiles of one frame share.
struct Picture::Frame {
  const Stage& stage;
  Poses poses;
  std::span<const anim::VisibleAgent> visible = stage.selection().visible;
  std::span<const std::uint8_t> mesh_lods = mesh_choice_of(stage).lods();
  std::uint32_t characters = static_cast<std::uint32_t>(stage.characters().size());
  std::uint32_t runs = static_cast<std::uint32_t>(stage.shown().slots().page_count()) * characters * lods;
  bool has_morphs = std::ranges::any_of(
      stage.characters(), [](const CharacterSource& source) { return !source.character->morph_bones.empty(); });
  bool lod_as_color = stage.tuning().debug_view == DebugView::mesh_lod;

  std::uint32_t run_of(std::size_t at) const {
    const std::uint32_t agent = visible[at].agent;
    const ShownPose& pose = stage.pose_of(agent, poses);
    if (!pose.shown()) return not_drawn;
    const std::uint32_t lod = poses == Poses::exact ? 0 : mesh_lods[at];
    return (pose.to.page * characters + stage.crowd().characters()[agent]) * lods + lod;
  }
  render::CrowdBatch batch(std::uint32_t run, std::uint32_t first, std::uint32_t count) const {
    return {.page = run / lods / characters,
            .character = static_cast<std::uint8_t>(run / lods % characters),
            .mesh_lod = static_cast<std::uint8_t>(run % lods),
            .first_instance = first,
            .instance_count = count};
  }
};

void Picture::compose(const Stage& stage, Poses poses) {
  const Frame frame{stage, poses};
  make_room(stage);
  const std::span<Tile> tiles = cut_into_tiles(frame);
  visit_on_pus(stage, tiles, [&](Tile& tile) { choose_runs(frame, tile); });
  begin_runs(frame, tiles);
  visit_on_pus(stage, tiles, [&](Tile& tile) { write_records(frame, tile); });
  weight_count_ = 0;
  for (const Tile& tile : tiles) weight_count_ = std::max(weight_count_, tile.weights_end);
}

// There is room for the whole crowd from its first picture on, so that nothing is allocated when more come into view.
void Picture::make_room(const Stage& stage) {
  const std::size_t agents = stage.crowd().size();
  if (choices_.size() >= agents) return;
  choices_.resize(agents);
  records_.resize(agents);
}

// All tiles together count no more runs than there are agents. They count on cache lines of their own.
std::span<Picture::Tile> Picture::cut_into_tiles(const Frame& frame) {
  const std::size_t agents = frame.visible.size();
  const std::size_t line = (frame.runs / runs_a_line + 2) * runs_a_line;
  const auto jobs = static_cast<std::size_t>(frame.stage.system().options().pus);
  const std::size_t worthwhile = agents / std::max(agents_worth_a_job, line);
  const std::size_t count = std::clamp<std::size_t>(std::min(worthwhile, jobs), 1, most_tiles);
  run_counts_.assign(count * line, 0);
  const std::span<Tile> tiles = std::span(tiles_).first(count);
  for (std::size_t i = 0; i < count; ++i) {
    tiles[i].first = agents * i / count;
    tiles[i].end = agents * (i + 1) / count;
    tiles[i].runs = run_counts_.data() + i * line;
  }
  return tiles;
}

void Picture::choose_runs(const Frame& frame, Tile& tile) {
  tile.morphs.clear();
  for (std::size_t at = tile.first; at < tile.end; ++at) {
    Choice& choice = choices_[at] = {.run = frame.run_of(at), .weights = 0};
    if (choice.run == not_drawn) continue;
    ++tile.runs[choice.run];
    if (frame.has_morphs) choice.weights = tile.morphs.add(frame.stage, frame.visible[at]);
  }
}

// The tiles follow each other within a run, so that the sort is stable, and equal frames give equal pictures.
void Picture::begin_runs(const Frame& frame, std::span<Tile> tiles) {
  batches_.clear();
  std::uint32_t next = 0;
  for (std::uint32_t run = 0; run < frame.runs; ++run) {
    const std::uint32_t first = next;
    for (Tile& tile : tiles) next += std::exchange(tile.runs[run], next);
    if (next > first) batches_.push_back(frame.batch(run, first, next - first));
  }
  instance_count_ = next;
  std::size_t weights = 0;
  for (Tile& tile : tiles) {
    tile.first_weight = weights;
    weights += tile.morphs.all().size();
  }
  if (weights_.size() < weights) weights_.resize(weights);
}

void Picture::write_records(const Frame& frame, Tile& tile) {
  std::ranges::copy(tile.morphs.all(), weights_.begin() + static_cast<std::ptrdiff_t>(tile.first_weight));
  tile.weights_end = 0;
  for (std::size_t at = tile.first; at < tile.end; ++at) {
    const auto [run, weights] = choices_[at];
    if (run == not_drawn) continue;
    const anim::VisibleAgent& agent = frame.visible[at];
    render::InstanceRecord& record = records_[tile.runs[run]++];
    frame.stage.record(agent, record, frame.poses);
    if (frame.lod_as_color && agent.agent != frame.stage.selected()) {
      record.debug_color = debug_color(frame.stage.tuning(), {.mesh_lod = static_cast<int>(run % lods)});
    }
    if (weights > 0) name_weights(frame, tile, weights - 1, record);
  }
}

void Picture::name_weights(const Frame& frame, Tile& tile, std::uint32_t place, render::InstanceRecord& record) {
  const std::size_t first = tile.first_weight + place * render::weights_a_place;
  if (first / render::weights_a_place > render::largest_weight_place) return;
  record.hair |= static_cast<std::uint32_t>(first / render::weights_a_place + 1) << bits_below_weights;
  tile.weights_end = first + weights_taken_by(frame.stage, record.agent);
}

}  // namespace throng::app
