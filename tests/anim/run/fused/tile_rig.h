#pragma once

#include <vector>

#include "engine/anim/run/fused/tile_in_store.h"
#include "engine/anim/run/fused/tile_lists.h"
#include "engine/anim/run/program/step_walk.h"
#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/local_store.h"
#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim {

/// Makes all agents of a crowd one tile of strips of four, with a local store and lists of its own, so that a test can
/// run the parts of a fused task alone.
class TileRig {
 public:
  static constexpr std::size_t width = 4;

  explicit TileRig(const CrowdRig& crowd);

  TileInStore tile();
  Strip strip(const TileInStore& tile, std::size_t first) const;
  StepCursor first_step() { return {.block = blocks(), .prepared = scratch_.prepared.data()}; }
  std::byte* blocks() { return store_.fetch_buffer(0).data(); }

  TileLists lists;
  CopyEngine engine;

 private:
  std::vector<ClipStreams> clips_;
  UpdateContext context_;
  std::vector<AgentWork> work_;
  std::vector<AgentRun> runs_;
  LocalStore store_;
  FusedScratch scratch_;
};

}  // namespace throng::anim
