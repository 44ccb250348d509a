#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "throng/render/crowd_draw.h"

#include "engine/render/light/cascades.h"

namespace throng::render {

/// Chooses which agents may cast a shadow into which cascade, for all cascades in one pass over the instances. Jobs
/// do it in tiles; the result is the same for any number of jobs. Memory is kept from frame to frame.
class Casters {
 public:
  /// Chooses among the instances of a frame's batches. `reaches` has the metres that each character's surface reaches
  /// from where an instance of scale 1 stands. Each instance is looked at once, however many pieces it wears.
  void choose(const CrowdFrame& frame, std::span<const float> reaches, const SunAxes& axes, const CastLimits& limits);

  /// Returns the casters, as indices of instances: by cascade, then by batch, in the order of the instances.
  std::span<const std::uint32_t> all() const { return std::span(room_).first(length_); }
  /// Returns how many of them are of a cascade and a batch.
  std::uint32_t count(std::size_t cascade, std::size_t batch) const { return counts_[batch][cascade]; }
  /// Returns the largest scale of the instances that were looked at; 0 without any.
  float largest_scale() const { return largest_scale_; }

 private:
  using Counts = std::array<std::uint32_t, cascade_count>;
  struct Frame;

  /// Instances that one job looks at, counted through all runs or batches. Its list for a cascade begins where it would
  /// if all instances cast into all cascades before.
  struct Tile {
    std::size_t first = 0, end = 0;
    Counts found{};  // by cascade
    float largest_scale = 0.0F;
  };

  void look_at_instances(const Frame& frame, Tile& tile);
  void list_all(const Frame& frame, Tile& tile);
  void list_batch(const Frame& frame, std::size_t batch, std::uint32_t first, std::uint32_t count, Tile& tile);
  template <typename Visit>
  static void visit_in_tiles(std::size_t total, const RenderJobs& jobs, std::span<Tile> tiles, const Visit& visit);
  static void for_each_part(std::span<const CrowdBatch> batches, const Tile& tile, const auto& visit);
  void close_gaps(std::size_t total, std::span<const Tile> tiles);

  std::vector<std::uint8_t> casts_;  // [instance] a bit of each cascade, where batches are lists
  std::vector<std::uint32_t> room_;
  std::size_t length_ = 0;
  float largest_scale_ = 0.0F;
  std::vector<Counts> counts_;  // [batch]
};

}  // namespace throng::render
