#include "engine/anim/bake/character.h"

#include <algorithm>
#include <cassert>

#include <glm/geometric.hpp>

namespace throng::anim {

double ground_speed(const Character& character, int clip) {
  assert(clip >= 0 && clip < static_cast<int>(character.clips.size()));
  const BakedClip& baked = character.clips[static_cast<std::size_t>(clip)];
  if (baked.duration <= 0) return 0.0;
  const double travel = glm::length(baked.loop_displacement);
  return travel > 0.0 ? travel / to_seconds(baked.duration) : baked.stance_speed;
}

}  // namespace throng::anim
