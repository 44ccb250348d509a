#pragma once

#include <cstdint>

#include "engine/anim/lod/level_of_detail.h"

namespace throng::app {

/// The cost that level of detail saves, as the cost model predicts it.
struct SavedCost {
  double culling_percent = 0.0;   ///< of the cost of all agents; saved on agents out of view
  double skipping_percent = 0.0;  ///< of the cost of agents in view; saved by skipped updates
  double bones_percent = 0.0;     ///< of the cost of agents in view; saved by dropped bones
};
SavedCost saved_cost(const anim::LodCost& cost, LodRule rule);

/// Sums up level of detail over the frames of a run.
struct LodSums {
  struct LimitCount {
    std::uint64_t frames = 0, held = 0;
    void add(bool holds);
    double percent() const;
  };

  anim::LodFigures last;
  double predicted_ms = 0.0;
  std::uint64_t frames = 0;
  anim::LodCost cost;
  LimitCount error;  ///< frames in which something was measured
  LimitCount budget;

  void add(const anim::LodFigures& figures);
  double predicted_ms_a_frame() const;
  SavedCost saved(LodRule rule) const { return saved_cost(cost, rule); }
};

}  // namespace throng::app
