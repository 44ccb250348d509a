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

glm::dvec2 ground_velocity(const Character& character, int clip) {
  assert(clip >= 0 && clip < static_cast<int>(character.clips.size()));
  const BakedClip& baked = character.clips[static_cast<std::size_t>(clip)];
  const double speed = baked.ground_speed;
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

void travel_by_steps(Character& character) {
  for (std::size_t clip = 0; clip < character.clips.size(); ++clip) {
    BakedClip& baked = character.clips[clip];
    if (baked.ground_speed == 0.0 || !baked.root_motion.keys.empty()) continue;
    const glm::dvec2 way = ground_velocity(character, static_cast<int>(clip)) * to_seconds(baked.duration);
    baked.root_motion = straight_root_curve(baked.duration, {way.x, 0.0, way.y});
    baked.loop_displacement = whole_motion(baked.root_motion).translation;
  }
}

}  // namespace throng::anim
