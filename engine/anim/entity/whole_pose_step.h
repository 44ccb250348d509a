#pragma once

#include <algorithm>

#include "engine/anim/base/units.h"
#include "engine/anim/entity/entity_run.h"

namespace throng::anim {

/// The times that an entity which tweaks the whole pose of its source carries from `advance` to `pose_whole`.
struct WholePoseStep {
  float elapsed;  ///< seconds since the last update; below 0: wound back
  float seconds;  ///< the same, but 0 where it is wound back: for memory that cannot be wound back
};
inline constexpr std::size_t whole_pose_prepared_bytes = 64;

/// Uses up the time of an update and takes the source's velocity.
inline WholePoseStep begin_whole_pose(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& state = entity.as<AnimationStateHeader>();
  const auto elapsed = static_cast<float>(to_seconds(state.delta_time));
  const WholePoseStep step{.elapsed = elapsed, .seconds = std::max(elapsed, 0.0F)};
  state.delta_time = Ticks{};
  take_velocity(state, sources[0]);
  entity.prepared_as<WholePoseStep>() = step;
  return step;
}

}  // namespace throng::anim
