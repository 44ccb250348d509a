#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/show/morph_weights.h"
#include "app/stage/stage.h"
#include "engine/render/crowd_draw.h"

namespace throng::app {

/// Sorts the visible agents of a stage into runs of the same palette page, character and mesh LOD, so that one
/// instanced draw shows a run. The runs ascend by page, then by character. Memory is kept from frame to frame.
class Picture {
 public:
  /// Sorts the agents. Exact poses are drawn with their full meshes.
  void compose(const Stage& stage, Poses poses = Poses::shown);

  std::span<const render::InstanceRecord> instances() const { return instances_; }
  std::span<const render::CrowdBatch> batches() const { return batches_; }
  std::span<const float> morph_weights() const { return morphs_.all(); }

 private:
  struct Entry {
    std::uint32_t run;  // page, character, mesh LOD
    render::InstanceRecord record;
  };

  void sort_into_runs(std::uint32_t characters);

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> run_starts_;
  std::vector<render::InstanceRecord> instances_;
  std::vector<render::CrowdBatch> batches_;
  MorphWeights morphs_;
};

}  // namespace throng::app
