#include "engine/crowd/sorted_draws.h"

#include <algorithm>
#include <utility>

#include "throng/render/crowd_mesh_data.h"

#include "engine/base/run_jobs.h"

namespace throng {
namespace {

constexpr std::uint32_t lods = render::largest_mesh_lod_count;
constexpr std::uint32_t not_drawn = UINT32_MAX;
constexpr std::size_t agents_worth_a_job = 1024;
constexpr std::size_t runs_a_line = 64 / sizeof(std::uint32_t);  // of the cache

}  // namespace

/// All that the tiles of one frame share.
struct SortedDraws::Frame {
  const SystemView& view;
  const anim::AnimationSystem& system;
  const DrawnAgents& drawn;
  Poses poses;
  std::span<const anim::VisibleAgent> visible = view.selection().visible;
  std::span<const std::uint8_t> mesh_lods = view.mesh_choice().lods();
  std::uint32_t characters = static_cast<std::uint32_t>(view.characters().size());
  std::uint32_t runs = static_cast<std::uint32_t>(view.shown().slots().page_count()) * characters * lods;
  bool has_morphs = std::ranges::any_of(
      view.characters(), [](const ViewedCharacter& viewed) { return !viewed.character->morph_bones.empty(); });
  bool stand_ins = false;  ///< silhouettes of agents near by are listed too, for shadows

  std::uint32_t run_of(std::size_t at) const {
    const std::uint32_t agent = visible[at].agent;
    const ShownPose& pose = view.pose_of(agent, poses);
    if (!pose.shown()) return not_drawn;
    const std::uint32_t lod = poses == Poses::exact ? 0 : mesh_lods[at];
    return (pose.to.page * characters + drawn.agents.characters[agent]) * lods + lod;
  }
  std::uint32_t run_of(const render::CrowdBatch& batch) const {
    return (batch.page * characters + batch.character) * lods + batch.mesh_lod;
  }
  render::CrowdBatch batch(std::uint32_t run, std::uint32_t first, std::uint32_t count) const {
    return {.page = run / lods / characters,
            .character = static_cast<std::uint8_t>(run / lods % characters),
            .mesh_lod = static_cast<std::uint8_t>(run % lods),
            .first = first,
            .count = count};
  }
  /// Calls visit(list) for each list, counted through all runs, on which the agent at a place in view is.
  void for_each_list(std::size_t at, std::uint32_t run, std::uint32_t pieces, const auto& visit) const {
    const render::Outfit& outfit = drawn.outfits[visible[at].agent];
    const std::uint32_t put_away = drawn.put_away.empty() ? render::Outfit::no_piece : drawn.put_away[at];
    const std::size_t first = std::size_t{run} * pieces;
    for_each_worn(outfit, run % lods, [&](std::uint32_t piece) {
      if (piece != put_away) visit(first + piece);
    });
    const bool stands_in = stand_ins && run % lods < render::first_silhouette_lod && outfit.count > 0;
    if (stands_in) visit(first + outfit.silhouette);
  }
  /// Fills the record of the agent at a place in view, but for its weights.
  render::InstanceRecord record(std::size_t at) const {
    const std::uint32_t agent = visible[at].agent;
    const ShownPose& pose = view.pose_of(agent, poses);
    const glm::vec3 position = drawn.agents.positions[agent];
    const Heading heading = drawn.agents.headings[agent];
    const std::uint8_t character = drawn.agents.characters[agent];
    return {.position = {position.x, position.y, position.z},
            .scale = drawn.agents.scales[agent],
            .heading_cosine = heading.cosine,
            .heading_sine = heading.sine,
            .palette_from = pose.from_word(),
            .palette_to = pose.to_word(),
            .blend_start = pose.from_time,
            .blend_duration = pose.to_time - pose.from_time,
            .agent = agent,
            .debug_color = drawn.colors.empty() ? 0 : drawn.colors[at],
            .bone_level = pose.level(),
            .weights = 0,
            .contact_scale = drawn.contact_scales.empty() ? 1.0F : drawn.contact_scales[character]};
  }
};

void SortedDraws::compose(const SystemView& view, const anim::AnimationSystem& system, const DrawnAgents& drawn,
                          Poses poses) {
  Frame frame{view, system, drawn, poses};
  make_room(drawn);
  frame.stand_ins = all_have_silhouettes_ && drawn.silhouettes_cast;
  const std::span<Tile> tiles = cut_into_tiles(frame);
  const auto visit = [&](const auto& tiled) {
    run_jobs(system.executor(), tiles.size(), [&](std::size_t tile) { tiled(tiles[tile]); });
  };
  visit([&](Tile& tile) { choose_runs(frame, tile); });
  begin_runs(frame, tiles);
  begin_lists(frame, tiles);
  visit([&](Tile& tile) { write_records(frame, tile); });
}

// There is room for the whole crowd from its first picture on, so that nothing is allocated when more come into view.
void SortedDraws::make_room(const DrawnAgents& drawn) {
  const std::size_t agents = drawn.agents.positions.size();
  look_at_outfits(drawn);
  if (choices_.size() >= agents) return;
  choices_.resize(agents);
  records_.resize(agents);
}

void SortedDraws::look_at_outfits(const DrawnAgents& drawn) {
  if (drawn.outfits_number == outfits_number_) return;
  outfits_number_ = drawn.outfits_number;
  std::size_t most_drawn = 0;
  pieces_ = 0;
  all_have_silhouettes_ = true;
  for (const render::Outfit& outfit : drawn.outfits) {
    most_drawn += std::max<std::size_t>(outfit.count, 1) + 1;
    all_have_silhouettes_ &= outfit.count == 0 || outfit.silhouette != render::Outfit::no_piece;
    for (std::size_t i = 0; i < outfit.count; ++i) pieces_ = std::max(pieces_, outfit.pieces[i] + 1U);
    if (outfit.silhouette != render::Outfit::no_piece) pieces_ = std::max(pieces_, outfit.silhouette + 1U);
  }
  if (drawn_.size() < most_drawn) drawn_.resize(most_drawn);
  is_silhouette_.assign(pieces_, false);
  for (const render::Outfit& outfit : drawn.outfits) {
    if (outfit.silhouette != render::Outfit::no_piece) is_silhouette_[outfit.silhouette] = true;
  }
}

// All tiles together count no more runs than there are agents. They count on cache lines of their own.
std::span<SortedDraws::Tile> SortedDraws::cut_into_tiles(const Frame& frame) {
  const std::size_t agents = frame.visible.size();
  const std::size_t line = (frame.runs / runs_a_line + 2) * runs_a_line;
  const auto jobs = static_cast<std::size_t>(frame.system.options().pus);
  const std::size_t worthwhile = agents / std::max(agents_worth_a_job, line);
  const std::size_t count = std::clamp<std::size_t>(std::min(worthwhile, jobs), 1, most_tiles);
  const std::size_t list_line = (std::size_t{frame.runs} * pieces_ / runs_a_line + 1) * runs_a_line;
  run_counts_.assign(count * line, 0);
  if (list_counts_.size() < count * list_line) list_counts_.resize(count * list_line);
  const std::span<Tile> tiles = std::span(tiles_).first(count);
  for (std::size_t i = 0; i < count; ++i) {
    tiles[i].first = agents * i / count;
    tiles[i].end = agents * (i + 1) / count;
    tiles[i].runs = run_counts_.data() + i * line;
    tiles[i].lists = wears_outfits() ? list_counts_.data() + i * list_line : nullptr;
  }
  return tiles;
}

void SortedDraws::choose_runs(const Frame& frame, Tile& tile) {
  tile.morphs.clear();
  if (wears_outfits()) std::fill_n(tile.lists, std::size_t{frame.runs} * pieces_, 0U);
  for (std::size_t at = tile.first; at < tile.end; ++at) {
    Choice& choice = choices_[at] = {.run = frame.run_of(at), .weights = 0};
    if (choice.run == not_drawn) continue;
    ++tile.runs[choice.run];
    if (wears_outfits()) {
      frame.for_each_list(at, choice.run, pieces_, [&](std::size_t list) { ++tile.lists[list]; });
    }
    if (frame.has_morphs) {
      const anim::VisibleAgent& agent = frame.visible[at];
      const std::uint8_t character = frame.drawn.agents.characters[agent.agent];
      choice.weights = tile.morphs.add(frame.system, *frame.view.characters()[character].character, agent);
    }
  }
}

// The tiles follow each other within a run, so that the sort is stable, and equal frames give equal pictures.
void SortedDraws::begin_runs(const Frame& frame, std::span<Tile> tiles) {
  runs_.clear();
  std::uint32_t next = 0;
  for (std::uint32_t run = 0; run < frame.runs; ++run) {
    const std::uint32_t first = next;
    for (Tile& tile : tiles) next += std::exchange(tile.runs[run], next);
    if (next > first) runs_.push_back(frame.batch(run, first, next - first));
  }
  instance_count_ = next;
  weight_count_ = 0;
  for (Tile& tile : tiles) {
    tile.first_weight = weight_count_;
    weight_count_ += tile.morphs.all().size();
  }
  if (weights_.size() < weight_count_) weights_.resize(weight_count_);
}

void SortedDraws::begin_lists(const Frame& frame, std::span<Tile> tiles) {
  lists_.clear();
  std::uint32_t next = 0;
  for (const render::CrowdBatch& batch : wears_outfits() ? std::span(runs_) : std::span<render::CrowdBatch>()) {
    const std::size_t first_list = std::size_t{frame.run_of(batch)} * pieces_;
    for (std::uint32_t piece = 0; piece < pieces_; ++piece) {
      const std::uint32_t first = next;
      for (Tile& tile : tiles) next += std::exchange(tile.lists[first_list + piece], next);
      if (next == first) continue;
      lists_.push_back(batch);
      lists_.back().piece = static_cast<std::uint16_t>(piece);
      lists_.back().first = first;
      lists_.back().count = next - first;
      lists_.back().stands_in = is_silhouette_[piece] && batch.mesh_lod < render::first_silhouette_lod;
    }
  }
  drawn_count_ = next;
}

void SortedDraws::write_records(const Frame& frame, Tile& tile) {
  std::ranges::copy(tile.morphs.all(), weights_.begin() + static_cast<std::ptrdiff_t>(tile.first_weight));
  for (std::size_t at = tile.first; at < tile.end; ++at) {
    const auto [run, weights] = choices_[at];
    if (run == not_drawn) continue;
    const std::uint32_t number = tile.runs[run]++;
    if (wears_outfits()) {
      frame.for_each_list(at, run, pieces_, [&](std::size_t list) { drawn_[tile.lists[list]++] = number; });
    }
    render::InstanceRecord& record = records_[number] = frame.record(at);
    if (weights > 0) record.weights = static_cast<std::uint32_t>(tile.first_weight) + weights;
  }
}

}  // namespace throng
