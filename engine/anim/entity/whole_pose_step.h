#pragma once

#include <algorithm>

#include "engine/anim/base/units.h"
#include "engine/anim/entity/entity_run.h"

namespace throng::anim {

/// What entities that tweak the whole pose of one source carry from `advance` to `pose_whole`.
struct WholePoseStep {
  float elapsed;  ///< seconds since the last update; below 0: wound back
  float seconds;  ///< of them, for what remembers more than a time and is not wound back: 0 or more
};
inline constexpr std::size_t whole_pose_prepared_bytes = 64;

/// Uses up the time of an update and moves as the source does.
inline WholePoseStep begin_whole_pose(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& state = entity.as<AnimationStateHeader>();
  const auto elapsed = static_cast<float>(to_seconds(state.delta_time));
  const WholePoseStep step{.elapsed = elapsed, .seconds = std::max(elapsed, 0.0F)};
  state.delta_time = 0;
  take_velocity(state, sources[0]);
  entity.prepared_as<WholePoseStep>() = step;
  return step;
}

}  // namespace throng::anim
