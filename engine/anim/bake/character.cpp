#include "engine/anim/bake/character.h"

#include <algorithm>
#include <cassert>

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
  const auto has_stream = [](const BakedClip& clip) { return clip.keyframe_block.get() != nullptr; };
  const bool plays = !character.clips.empty() && std::ranges::all_of(character.clips, has_stream);
  return plays ? nullptr : "the character has no clips, or one without a stream";
}

double ground_speed(const Character& character, int clip) {
  assert(clip >= 0 && clip < static_cast<int>(character.clips.size()));
  const BakedClip& baked = character.clips[static_cast<std::size_t>(clip)];
  if (baked.duration <= 0) return 0.0;
  const double travel = glm::length(baked.loop_displacement);
  if (travel > 0.0) return travel / to_seconds(baked.duration);
  return stance_speed(character.skeleton, baked.keyframe(), character.height);
}

}  // namespace throng::anim
