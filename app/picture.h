#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "app/stage.h"
#include "engine/render/crowd_draw.h"

namespace throng::app {

/// Sorts the visible agents of a stage into runs that one instanced draw each can show: same palette page and mesh LOD,
/// in ascending order of page. Memory is kept from frame to frame.
class Picture {
 public:
  /// `mesh_lod(pixels_tall, at_least)` says which mesh LOD an agent of that size gets.
  using PickMeshLod = std::function<int(float pixels_tall, int at_least)>;

  void compose(const Stage& stage, const PickMeshLod& mesh_lod);

  std::span<const render::InstanceRecord> instances() const { return instances_; }
  std::span<const render::CrowdBatch> batches() const { return batches_; }

 private:
  struct Entry {
    std::uint32_t run;  // page, mesh LOD
    render::InstanceRecord record;
  };

  void sort_into_runs();

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> run_starts_;
  std::vector<render::InstanceRecord> instances_;
  std::vector<render::CrowdBatch> batches_;
};

}  // namespace throng::app
