#pragma once

#include <algorithm>
#include <span>

#include "engine/anim/base/units.h"
#include "engine/anim/entity/entity_kind.h"

namespace throng::anim {

/// What entities that tweak the whole pose of one source carry from `advance` to `pose_whole`.
struct WholePoseStep {
  float seconds;  ///< since the last update, 0 or more: what they remember is not wound back
};
inline constexpr std::size_t whole_pose_prepared_bytes = 64;

/// Uses up the time of an update and moves as the source does.
inline WholePoseStep begin_whole_pose(const EntityInStore& entity,
                                      std::span<const AnimationStateHeader* const> sources) {
  auto& state = entity.as<AnimationStateHeader>();
  const WholePoseStep step{.seconds = static_cast<float>(to_seconds(std::max<Ticks>(state.delta_time, 0)))};
  state.delta_time = 0;
  take_velocity(state, *sources[0]);
  entity.prepared_as<WholePoseStep>() = step;
  return step;
}

}  // namespace throng::anim
