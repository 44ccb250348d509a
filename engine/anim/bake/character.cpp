#include "engine/anim/bake/character.h"

#include <algorithm>

namespace throng::anim {

const char* fault_of(const Character& character) {
  const Skeleton& skeleton = character.skeleton;
  if (skeleton.bones.empty()) return "the character has no bones";
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

void keep_played_streams(Character& character) {
  for (BakedClip& clip : character.clips) {
    if (clip.sampled_block != nullptr) clip.keyframe_block.reset();
  }
}

void travel_by_steps(Character& character) {
  for (BakedClip& baked : character.clips) {
    if (baked.ground_speed() == 0.0 || !baked.root_motion.keys.empty()) continue;
    const glm::dvec2 way = baked.ground_velocity * to_seconds(baked.duration);
    baked.root_motion = straight_root_curve(baked.duration, {way.x, 0.0, way.y});
    baked.loop_displacement = whole_motion(baked.root_motion).translation;
  }
}

}  // namespace throng::anim
