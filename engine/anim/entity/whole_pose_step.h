#pragma once

#include <algorithm>

#include "engine/anim/base/units.h"
#include "engine/anim/entity/entity_run.h"
#include "engine/anim/entity/fading_weight.h"

namespace throng::anim {

/// The time that an entity which tweaks the whole pose of its source carries from `advance` to `pose_whole`.
struct WholePoseStep {
  float seconds;  ///< since the last update; 0 where it is wound back: for memory that cannot be wound back
};
inline constexpr std::size_t whole_pose_prepared_bytes = 64;

/// Uses up the time of an update, takes the source's velocity, and moves the entity's `weight`.
template <typename Entity>
void advance_weighed(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& own = entity.as<Entity>();
  const auto elapsed = static_cast<float>(to_seconds(own.state.delta_time));
  own.state.delta_time = Ticks{};
  take_velocity(own.state, sources[0]);
  entity.prepared_as<WholePoseStep>().seconds = std::max(elapsed, 0.0F);
  advance_weight(own.weight, elapsed);
}

}  // namespace throng::anim
