#include "engine/anim/agent/system_snapshot.h"

namespace throng::anim {

void AnimationSystem::snapshot(SystemSnapshot& into) const {
  const Turn turn(parts_.turn, "AnimationSystem::snapshot");
  if (!turn) return;
  parts_.population.snapshot(into.population_);
  into.hashes_ = parts_.frame.hashes();
}

Status AnimationSystem::restore(const SystemSnapshot& from) {
  const Turn turn(parts_.turn, "AnimationSystem::restore");
  if (!turn) return Turn::refusal();
  if (Status same = parts_.population.can_restore(from.population_); !same) return same;
  LocalStoreDemand needs = parts_.pus.demand(parts_.population);
  from.population_.widen(needs);
  if (Status fits = parts_.pus.fit(parts_.population, needs); !fits) return fits;
  if (Status restored = parts_.population.restore(from.population_); !restored) return restored;
  parts_.frame.restore(from.hashes_);
  make_room();
  return Done{};
}

}  // namespace throng::anim
