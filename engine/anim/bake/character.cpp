#include "engine/anim/bake/character.h"

#include <algorithm>
#include <cassert>

#include <glm/geometric.hpp>

#include "engine/anim/bake/ground_speed.h"

namespace throng::anim {

const char* fault_of(const Character& character) {
  const Skeleton& skeleton = character.skeleton;
  if (skeleton.bones.empty()) return "the character has no bones: bake one of a model that check_model() accepts";
  if (skeleton.bone_count() > max_bones) return "the character has more than 1,024 bones";
  const bool has_levels =
      !skeleton.level_bone_counts.empty() && skeleton.level_bone_counts.front() == skeleton.bone_count();
  if (!has_levels || character.hierarchy.bone_count != skeleton.bone_count()) {
    return "the character's hierarchy or levels are not those of its skeleton";
  }
  const auto has_lost_streams = [](const BakedClip& clip) { return clip.is_empty() && !clip.name.empty(); };
  if (std::ranges::any_of(character.clips, has_lost_streams)) return "the character has a clip without a stream";
  return std::ranges::all_of(character.clips, &BakedClip::is_empty) ? "the character has no clips" : nullptr;
}

double ground_speed(const Character& character, int clip) {
  assert(clip >= 0 && clip < static_cast<int>(character.clips.size()));
  const BakedClip& baked = character.clips[static_cast<std::size_t>(clip)];
  if (baked.duration <= Ticks{}) return 0.0;
  if (baked.root_motion.keys.empty()) return baked.stance_speed;
  const RootVelocity velocity = root_velocity(baked.root_motion, 0);
  const double speed = glm::length(glm::dvec2(velocity.linear.x, velocity.linear.z));
  constexpr double least_arc = 0.25;  // metres a second: a body that turns on the spot shifts its weight
  if (velocity.yaw != 0.0) return speed < least_arc ? 0.0 : speed;
  const double travel = glm::length(glm::dvec2(baked.loop_displacement.x, baked.loop_displacement.z));
  return travel / to_seconds(baked.duration);
}

glm::dvec2 ground_velocity(const Character& character, int clip) {
  const double speed = ground_speed(character, clip);
  const BakedClip& baked = character.clips[static_cast<std::size_t>(clip)];
  glm::dvec2 way(0.0);
  if (speed == 0.0) return way;
  if (baked.root_motion.keys.empty()) {
    way = -stance_velocity(sample_stride(character.skeleton, baked.keyframe(), character.height));
  } else {
    const glm::dvec3 travels = root_velocity(baked.root_motion, 0).linear;
    way = {travels.x, travels.z};
  }
  const double length = glm::length(way);
  return length > 0.0 ? way * (speed / length) : glm::dvec2(0.0, speed);
}

}  // namespace throng::anim
