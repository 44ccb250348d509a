#include "engine/render/passes/casters.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>

namespace throng::render {
namespace {

constexpr std::size_t instances_worth_a_job = 16384;
constexpr std::size_t most_tiles = 64;

std::size_t total_of(std::span<const CrowdBatch> batches) {
  std::size_t total = 0;
  for (const CrowdBatch& batch : batches) total += batch.instance_count;
  return total;
}

std::size_t tiles_for(std::size_t instances, JobRunner* jobs) {
  const auto at_once = static_cast<std::size_t>(jobs == nullptr ? 1 : jobs->jobs_at_once());
  return std::clamp<std::size_t>(std::min(instances / instances_worth_a_job, at_once), 1, most_tiles);
}

}  // namespace

/// All that the tiles of one frame share.
struct Casters::Frame {
  const CrowdFrame& crowd;
  std::span<const float> reaches;  ///< [batch]
  const SunAxes& axes;
  const CastLimits& limits;
  std::size_t total;  ///< instances of all batches
};

void Casters::choose(const CrowdFrame& frame, std::span<const float> reaches, const SunAxes& axes,
                     const CastLimits& limits) {
  assert(reaches.size() == frame.batches.size());
  const Frame shared{frame, reaches, axes, limits, total_of(frame.batches)};
  if (room_.size() < shared.total * cascade_count) room_.resize(std::bit_ceil(shared.total * cascade_count));
  counts_.assign(frame.batches.size(), {});
  std::array<Tile, most_tiles> tiles;
  const std::size_t count = tiles_for(shared.total, frame.jobs);
  for (std::size_t i = 0; i < count; ++i) {
    tiles.at(i).first = shared.total * i / count;
    tiles.at(i).end = shared.total * (i + 1) / count;
  }
  run_jobs(frame.jobs, static_cast<int>(count),
           [&](int tile) { look_at_all(shared, tiles.at(static_cast<std::size_t>(tile))); });
  largest_scale_ = 0.0F;
  for (const Tile& tile : std::span(tiles).first(count)) largest_scale_ = std::max(largest_scale_, tile.largest_scale);
  close_gaps(shared.total, std::span(tiles).first(count));
}

void Casters::look_at_all(const Frame& frame, Tile& tile) {
  std::size_t first_of_batch = 0;
  for (std::size_t i = 0; i < frame.crowd.batches.size() && first_of_batch < tile.end; ++i) {
    const CrowdBatch& batch = frame.crowd.batches[i];
    const std::size_t end_of_batch = first_of_batch + batch.instance_count;
    const std::size_t first = std::max(tile.first, first_of_batch), end = std::min(tile.end, end_of_batch);
    if (first < end) {
      look_at_batch(frame, i, batch.first_instance + static_cast<std::uint32_t>(first - first_of_batch),
                    static_cast<std::uint32_t>(end - first), tile);
    }
    first_of_batch = end_of_batch;
  }
}

// Writes each instance to each list, and the next one over it where it casts nothing there: so nothing branches.
void Casters::look_at_batch(const Frame& frame, std::size_t batch, std::uint32_t first, std::uint32_t count,
                            Tile& tile) {
  std::array<std::uint32_t*, cascade_count> lists{};
  for (std::size_t i = 0; i < cascade_count; ++i) lists.at(i) = room_.data() + i * frame.total + tile.first;
  const Counts before = tile.found;
  Counts found = before;
  float largest_scale = tile.largest_scale;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const InstanceRecord& record = frame.crowd.instances[i];
    const glm::vec3 place(record.position[0], record.position[1], record.position[2]);
    largest_scale = std::max(largest_scale, record.scale);
    const Counts casts = may_cast(frame.limits, frame.axes.along(place), frame.reaches[batch] * record.scale);
    for (std::size_t cascade = 0; cascade < cascade_count; ++cascade) {
      lists[cascade][found[cascade]] = i;
      found[cascade] += casts[cascade];
    }
  }
  tile.found = found;
  tile.largest_scale = largest_scale;
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
