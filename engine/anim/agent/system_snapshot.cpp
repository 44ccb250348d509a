#include "engine/anim/agent/system_snapshot.h"

#include <cassert>

namespace throng::anim {

void AnimationSystem::snapshot(SystemSnapshot& into) const {
  const Turn turn(parts_.turn, "Crowd::snapshot");
  if (!turn) return;
  parts_.population.snapshot(into.population_);
  into.hashes_ = parts_.frame.hashes();
}

namespace {

// Checks that the stores hold the graphs of a snapshot before anything changes.
Status restore_same_stream(SystemParts& parts, const PopulationSnapshot& from) {
  LocalStoreDemand needs = parts.pus.demand(parts.population);
  from.widen(needs);
  if (Status fits = parts.pus.fit(parts.population, needs); !fits) return fits;
  return parts.population.restore(from);
}

// Converts first and checks the stores then, since only converted graphs say how much they need.
Status restore_other_stream(SystemParts& parts, const PopulationSnapshot& from) {
  PopulationSnapshot now;
  parts.population.snapshot(now);
  if (Status restored = parts.population.restore(from); !restored) return restored;
  Status fits = parts.pus.fit(parts.population, parts.pus.demand(parts.population));
  if (fits) return fits;
  const Status as_before = parts.population.restore(now);
  assert(as_before && "it was taken under the same schedule");
  return fits;
}

}  // namespace

Status AnimationSystem::restore(const SystemSnapshot& from) {
  const Turn turn(parts_.turn, "Crowd::restore");
  if (!turn) return Turn::refusal();
  if (Status same = parts_.population.can_restore(from.population_); !same) return same;
  const bool same_stream = from.population_.stream == options().stream;
  Status restored =
      same_stream ? restore_same_stream(parts_, from.population_) : restore_other_stream(parts_, from.population_);
  if (!restored) return restored;
  parts_.frame.restore(from.hashes_);
  make_room();
  return Done{};
}

}  // namespace throng::anim
