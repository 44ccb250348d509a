#include "engine/anim/bake/character.h"

#include <algorithm>
#include <cassert>

#include "engine/anim/bake/ground_speed.h"

namespace throng::anim {

double ground_speed(const Character& character, int clip) {
  assert(clip >= 0 && clip < static_cast<int>(character.clips.size()));
  const BakedClip& baked = character.clips[static_cast<std::size_t>(clip)];
  if (baked.duration <= Ticks{}) return 0.0;
  const double travel = glm::length(baked.loop_displacement);
  if (travel > 0.0) return travel / to_seconds(baked.duration);
  return stance_speed(character.skeleton, baked.keyframe(), character.height);
}

}  // namespace throng::anim
