#include "engine/crowd/mesh_choice.h"

#include <algorithm>
#include <bit>

#include "engine/base/run_jobs.h"

namespace throng {
namespace {

constexpr std::size_t choices_worth_a_job = 512;
constexpr float least_level_pixels = 1.0F / 64.0F;

// The upper bits of a positive float are its octave and the eighth of it.
constexpr std::uint32_t eighth_of_octave(float value) { return std::bit_cast<std::uint32_t>(value) >> 20U; }

std::size_t class_of(float pixels, std::size_t classes) {
  const std::uint32_t step =
      eighth_of_octave(std::max(pixels, least_level_pixels)) - eighth_of_octave(least_level_pixels);
  return std::min<std::size_t>(step, classes - 1);
}

std::uint64_t saved_by(std::span<const std::uint32_t> triangles, int lod) {
  const std::uint32_t finer = triangles[static_cast<std::size_t>(lod) - 1],
                      coarser = triangles[static_cast<std::size_t>(lod)];
  return finer > coarser ? finer - coarser : 0;
}

}  // namespace

/// All that the tiles of one frame share.
struct MeshChoice::Frame {
  std::span<const anim::VisibleAgent> visible;
  std::span<const std::uint8_t> character_of;
  const MeshLods& lods;
  const MeshRules& rules;
  std::span<std::uint8_t> chosen;  ///< [place in visible]
  std::size_t last_class = 0;

  std::uint8_t character(std::size_t at) const { return character_of[visible[at].agent]; }
  float seen_px(std::size_t at, int lod) const {
    return lods.seen_px(rules, character(at), lod, visible[at].pixels_tall);
  }

  void choose(Tile& tile) const {
    tile.saved.fill(0);
    tile.figures = {};
    for (std::size_t at = tile.first; at < tile.end; ++at) {
      const int lod = lods.choose(rules, character(at), visible[at].pixels_tall);
      chosen[at] = static_cast<std::uint8_t>(lod);
      const std::span<const std::uint32_t> triangles = lods.triangles(character(at));
      if (triangles.empty()) continue;
      tile.figures.triangles_wanted += triangles[static_cast<std::size_t>(lod)];
      if (rules.has_budget()) count_savings(tile, at, lod, triangles);
    }
    tile.figures.triangles = tile.figures.triangles_wanted;
  }

  void count_savings(Tile& tile, std::size_t at, int lod, std::span<const std::uint32_t> triangles) const {
    for (int coarser = lod + 1; coarser < static_cast<int>(triangles.size()); ++coarser) {
      tile.saved[class_of(seen_px(at, coarser), error_classes)] += saved_by(triangles, coarser);
    }
  }

  void demote(Tile& tile) const {
    for (std::size_t at = tile.first; at < tile.end; ++at) {
      const int lod = demoted(tile, at);
      if (lod == chosen[at]) continue;
      chosen[at] = static_cast<std::uint8_t>(lod);
      ++tile.figures.demoted;
      tile.figures.demoted_error_px =
          std::max(tile.figures.demoted_error_px, lods.error_px(character(at), lod, visible[at].pixels_tall));
    }
  }

  int demoted(Tile& tile, std::size_t at) const {
    const std::span<const std::uint32_t> triangles = lods.triangles(character(at));
    int lod = chosen[at];
    for (; lod + 1 < static_cast<int>(triangles.size()); ++lod) {
      const std::size_t step = class_of(seen_px(at, lod + 1), error_classes);
      if (step > last_class || (step == last_class && tile.to_save == 0)) break;
      const std::uint64_t saved = saved_by(triangles, lod + 1);
      if (step == last_class) tile.to_save -= std::min(saved, tile.to_save);
      tile.figures.triangles -= saved;
    }
    return lod;
  }
};

void MeshChoice::choose(std::span<const anim::VisibleAgent> visible, std::span<const std::uint8_t> character_of,
                        const MeshLods& lods, const MeshRules& rules, Executor& executor, int jobs) {
  visible_ = visible.size();
  const std::size_t count =
      std::clamp<std::size_t>(std::min(visible_ / choices_worth_a_job, std::size_t(jobs)), 1, most_tiles);
  const std::span<Tile> tiles = std::span(tiles_).first(count);
  for (std::size_t i = 0; i < count; ++i) {
    tiles[i].first = visible_ * i / count;
    tiles[i].end = visible_ * (i + 1) / count;
  }
  Frame frame{visible, character_of, lods, rules, lods_};
  run_jobs(executor, count, [&](std::size_t tile) { frame.choose(tiles[tile]); });
  sum_up(tiles);
  if (!rules.has_budget() || figures_.triangles <= rules.triangle_budget) return;
  frame.last_class = plan_demotions(figures_.triangles - rules.triangle_budget, tiles);
  run_jobs(executor, count, [&](std::size_t tile) { frame.demote(tiles[tile]); });
  sum_up(tiles);
  figures_.budget_held = figures_.triangles <= rules.triangle_budget;
}

// The last class is shared out in the order of the agents, so that tiles do not matter.
std::size_t MeshChoice::plan_demotions(std::uint64_t to_save, std::span<Tile> tiles) {
  std::size_t last = 0;
  for (; last + 1 < error_classes; ++last) {
    std::uint64_t saved = 0;
    for (const Tile& tile : tiles) saved += tile.saved[last];
    if (saved >= to_save) break;
    to_save -= saved;
  }
  for (Tile& tile : tiles) {
    tile.to_save = std::min(to_save, tile.saved[last]);
    to_save -= tile.to_save;
  }
  return last;
}

void MeshChoice::sum_up(std::span<const Tile> tiles) {
  figures_ = {};
  for (const Tile& tile : tiles) {
    figures_.triangles += tile.figures.triangles;
    figures_.triangles_wanted += tile.figures.triangles_wanted;
    figures_.demoted += tile.figures.demoted;
    figures_.demoted_error_px = std::max(figures_.demoted_error_px, tile.figures.demoted_error_px);
  }
}

}  // namespace throng
