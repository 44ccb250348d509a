#include "app/show/figures/lod_sums.h"

namespace throng::app {
namespace {

double percent_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

SavedCost saved_cost(const anim::LodCost& cost, LodRule rule) {
  const bool culls = rule != LodRule::off;
  return {.culling_percent = culls ? percent_of(cost.everyone - cost.visible, cost.everyone) : 0.0,
          .skipping_percent = percent_of(cost.visible - cost.due_all_bones, cost.visible),
          .bones_percent = percent_of(cost.due_all_bones - cost.due, cost.visible)};
}

void LodSums::LimitCount::add(bool holds) {
  ++frames;
  held += holds ? 1U : 0U;
}

double LodSums::LimitCount::percent() const { return percent_of(held, frames); }

void LodSums::add(const anim::LodFigures& figures) {
  last = figures;
  ++frames;
  predicted_ms += figures.predicted_ms;
  cost += figures.cost;
  budget.add(figures.budget_held);
  if (figures.error_held) error.add(*figures.error_held);
}

double LodSums::predicted_ms_a_frame() const { return frames == 0 ? 0.0 : predicted_ms / static_cast<double>(frames); }

}  // namespace throng::app
