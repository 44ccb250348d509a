#include "engine/render/passes/casters.h"

#include <algorithm>
#include <atomic>
#include <bit>

#include "engine/base/run_jobs.h"

namespace throng::render {
namespace {

constexpr std::size_t instances_worth_a_job = 16384;
constexpr std::size_t most_tiles = 64;

std::size_t total_of(std::span<const CrowdBatch> batches) {
  std::size_t total = 0;
  for (const CrowdBatch& batch : batches) total += batch.count;
  return total;
}

std::size_t tiles_for(std::size_t instances, const RenderJobs& jobs) {
  return std::clamp<std::size_t>(std::min(instances / instances_worth_a_job, std::size_t(jobs.at_once)), 1, most_tiles);
}

}  // namespace

/// All that the tiles of one frame share.
struct Casters::Frame {
  const CrowdFrame& crowd;
  std::span<const float> reaches;  ///< [character]
  const SunAxes& axes;
  const CastLimits& limits;
  std::size_t total;  ///< of the counts of all batches

  /// Returns 1 for each cascade into which an instance casts.
  Counts casts_of(std::uint32_t instance, float reach) const {
    const InstanceRecord& record = crowd.instances[instance];
    const glm::vec3 place(record.position[0], record.position[1], record.position[2]);
    return may_cast(limits, axes.along(place), reach * record.scale);
  }
};

template <typename Visit>
void Casters::visit_in_tiles(std::size_t total, const RenderJobs& jobs, std::span<Tile> tiles, const Visit& visit) {
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    tiles[i].first = total * i / tiles.size();
    tiles[i].end = total * (i + 1) / tiles.size();
  }
  InOrder in_order;
  Executor& executor = jobs.executor == nullptr ? in_order : *jobs.executor;
  run_jobs(executor, tiles.size(), [&](std::size_t tile) { visit(tiles[tile]); });
}

void Casters::choose(const CrowdFrame& frame, std::span<const float> reaches, const SunAxes& axes,
                     const CastLimits& limits) {
  const Frame shared{frame, reaches, axes, limits, total_of(frame.batches)};
  if (room_.size() < shared.total * cascade_count) room_.resize(std::bit_ceil(shared.total * cascade_count));
  counts_.assign(frame.batches.size(), {});
  std::array<Tile, most_tiles> room_for_tiles;
  const auto tiles = std::span(room_for_tiles).first(tiles_for(shared.total, frame.jobs));
  if (!frame.drawn.empty()) {
    const std::size_t instances = frame.instances.size();
    if (casts_.size() < instances) casts_.resize(std::bit_ceil(instances));
    visit_in_tiles(total_of(frame.runs), frame.jobs, tiles, [&](Tile& tile) { look_at_instances(shared, tile); });
  }
  visit_in_tiles(shared.total, frame.jobs, tiles, [&](Tile& tile) { list_all(shared, tile); });
  largest_scale_ = 0.0F;
  for (const Tile& tile : tiles) largest_scale_ = std::max(largest_scale_, tile.largest_scale);
  close_gaps(shared.total, tiles);
}

/// Calls visit(batch, first, count) with the part of each batch that lies in a tile of all of them.
void Casters::for_each_part(std::span<const CrowdBatch> batches, const Tile& tile, const auto& visit) {
  std::size_t first_of_batch = 0;
  for (std::size_t i = 0; i < batches.size() && first_of_batch < tile.end; ++i) {
    const std::size_t end_of_batch = first_of_batch + batches[i].count;
    const std::size_t first = std::max(tile.first, first_of_batch), end = std::min(tile.end, end_of_batch);
    if (first < end) {
      visit(i, batches[i].first + static_cast<std::uint32_t>(first - first_of_batch),
            static_cast<std::uint32_t>(end - first));
    }
    first_of_batch = end_of_batch;
  }
}

void Casters::look_at_instances(const Frame& frame, Tile& tile) {
  for_each_part(frame.crowd.runs, tile, [&](std::size_t run, std::uint32_t first, std::uint32_t count) {
    const float reach = frame.reaches[frame.crowd.runs[run].character];
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Counts casts = frame.casts_of(i, reach);
      std::uint32_t bits = 0;
      for (std::size_t cascade = 0; cascade < cascade_count; ++cascade) bits |= casts[cascade] << cascade;
      casts_[i] = static_cast<std::uint8_t>(bits);
      tile.largest_scale = std::max(tile.largest_scale, frame.crowd.instances[i].scale);
    }
  });
}

void Casters::list_all(const Frame& frame, Tile& tile) {
  for_each_part(frame.crowd.batches, tile, [&](std::size_t batch, std::uint32_t first, std::uint32_t count) {
    list_batch(frame, batch, first, count, tile);
  });
}

// Writes each instance to each list, and the next one over it where it casts nothing there: so nothing branches.
void Casters::list_batch(const Frame& frame, std::size_t batch, std::uint32_t first, std::uint32_t count, Tile& tile) {
  std::array<std::uint32_t*, cascade_count> lists{};
  for (std::size_t i = 0; i < cascade_count; ++i) lists.at(i) = room_.data() + i * frame.total + tile.first;
  const Counts before = tile.found;
  Counts found = before;
  const auto add = [&](std::uint32_t instance, const Counts& casts) {
    for (std::size_t cascade = 0; cascade < cascade_count; ++cascade) {
      lists[cascade][found[cascade]] = instance;
      found[cascade] += casts[cascade];
    }
  };
  if (frame.crowd.drawn.empty()) {
    const float reach = frame.reaches[frame.crowd.batches[batch].character];
    float largest_scale = tile.largest_scale;
    for (std::uint32_t i = first; i < first + count; ++i) {
      largest_scale = std::max(largest_scale, frame.crowd.instances[i].scale);
      add(i, frame.casts_of(i, reach));
    }
    tile.largest_scale = largest_scale;
  } else {
    for (const std::uint32_t instance : frame.crowd.drawn.subspan(first, count)) {
      const std::uint32_t bits = casts_[instance];
      add(instance, {bits & 1U, bits >> 1U & 1U, bits >> 2U & 1U, bits >> 3U & 1U});
    }
  }
  tile.found = found;
  for (std::size_t i = 0; i < cascade_count; ++i) {
    // A batch may lie in several tiles.
    std::atomic_ref(counts_[batch].at(i)).fetch_add(found.at(i) - before.at(i), std::memory_order_relaxed);
  }
}

void Casters::close_gaps(std::size_t total, std::span<const Tile> tiles) {
  length_ = 0;
  for (std::size_t cascade = 0; cascade < cascade_count; ++cascade) {
    for (const Tile& tile : tiles) {
      const std::uint32_t* const from = room_.data() + cascade * total + tile.first;
      std::copy(from, from + tile.found.at(cascade), room_.data() + length_);
      length_ += tile.found.at(cascade);
    }
  }
}

}  // namespace throng::render
