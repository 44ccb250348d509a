#include "engine/anim/bake/reorder.h"

#include <cstddef>

#include "engine/anim/asset/encode_rows.h"
#include "engine/anim/bake/parallel.h"
#include "engine/anim/bake/root_motion.h"
#include "engine/anim/bake/sampled.h"

namespace throng::anim {

BakedClip without_streams(const BakedClip& clip) {
  return {.name = clip.name,
          .duration = clip.duration,
          .loops = clip.loops,
          .closing_step = clip.closing_step,
          .loop_displacement = clip.loop_displacement,
          .root_motion = clip.root_motion,
          .data_keys = clip.data_keys,
          .curves = clip.curves,
          .morphs = clip.morphs,
          .ground_velocity = clip.ground_velocity,
          .keyframe_block = {},
          .keyframe_error = clip.keyframe_error,
          .sampled_block = {},
          .sampled_rate = clip.sampled_rate,
          .sampled_error = clip.sampled_error,
          .error_bound = clip.error_bound,
          .sampled_rounding = clip.sampled_rounding,
          .note = clip.note,
          .generation = clip.generation};
}

namespace {

/// Returns the rows in another order of the bones. They are rounded once more where a lane changes its form: a packet
/// without motion keeps floats where others have int16.
AlignedBytes reorder_rows(const SampledStream& stream, std::span<const int> places) {
  const SampledRows from = rows_of(stream);
  SampledRows to = from;
  const std::size_t packet_floats = static_cast<std::size_t>(from.components) * packet_bones;
  const auto lane_of = [&](int bone) {
    return static_cast<std::size_t>(bone / packet_bones) * packet_floats +
           static_cast<std::size_t>(bone % packet_bones);
  };
  for (std::size_t row = 0; row < from.rows.size(); row += from.floats_in_row()) {
    for (int bone = 0; bone < from.bone_count; ++bone) {
      const std::size_t source = row + lane_of(bone);
      const std::size_t target = row + lane_of(places[static_cast<std::size_t>(bone)]);
      for (std::size_t i = 0; i < packet_floats; i += packet_bones) to.rows[target + i] = from.rows[source + i];
    }
  }
  return encode_rows(to, stream.duration);
}

std::vector<Box> reorder_boxes(const std::vector<Box>& boxes, const Skeleton& skeleton, const BoneOrder& order) {
  std::vector<Box> reordered;
  for (const int entry : palette_order(skeleton, order)) reordered.push_back(boxes[static_cast<std::size_t>(entry)]);
  return reordered;
}

}  // namespace

// Notes, errors, loops, root motion and data keys stay. They come from the largest distance over all points of the
// surface, from the roots and from the lowest joints, which are the same in any order.
BakedClip reorder_clip(const BakedClip& clip, const Skeleton& skeleton, std::span<const int> places) {
  BakedClip reordered = without_streams(clip);
  if (clip.is_empty()) return reordered;
  if (clip.keyframe() == nullptr) {
    reordered.sampled_block = reorder_rows(*clip.sampled(), places);
    return reordered;
  }
  reordered.keyframe_block = reorder_keyframe_stream(*clip.keyframe(), places);
  if (clip.sampled() == nullptr) return reordered;
  const SurfaceProxy unused;
  const SampleSource source{skeleton, unused, *reordered.keyframe(), straight_travel(clip.root_motion),
                            clip.error_bound - clip.keyframe_error};
  reordered.sampled_block = sample_as(source, *clip.sampled(), clip.sampled_rounding);
  return reordered;
}

std::vector<std::uint32_t> entries_of_levels(const Skeleton& skeleton) {
  std::vector<std::uint32_t> entries;
  for (const int bones : skeleton.level_bone_counts) {
    entries.push_back(static_cast<std::uint32_t>(palette_count_for_bones(skeleton, bones)));
  }
  return entries;
}

// Bounds and skip errors are the largest of all points, so no order changes them. The surface points begin at the first
// bone, so they are chosen again; that takes the rest pose alone.
Character reorder_character(const Character& character, const Model& model, const BoneOrder& order) {
  const std::vector<int> places = bone_places(order);
  Character reordered{.skeleton = model.skeleton,
                      .hierarchy = compile_hierarchy(model.skeleton),
                      .clips = std::vector<BakedClip>(character.clips.size()),
                      .data_key_names = character.data_key_names,
                      .curve_names = character.curve_names,
                      .height = character.height,
                      .bone_lod = {},
                      .skip_errors = character.skip_errors,
                      .bounds = character.bounds,
                      .morph_bones = character.morph_bones,
                      .morph_reach = character.morph_reach,
                      .surface_points = choose_surface_points(model),
                      .entry_boxes = reorder_boxes(character.entry_boxes, character.skeleton, order),
                      .level_entries = entries_of_levels(model.skeleton)};
  for (int& bone : reordered.morph_bones) bone = places[static_cast<std::size_t>(bone)];
  in_parallel(1 + character.clips.size(), [&](std::size_t part) {
    if (part == 0) {
      reordered.bone_lod = reorder_bone_lod(character.bone_lod, model, order.bones);
    } else {
      reordered.clips[part - 1] = reorder_clip(character.clips[part - 1], reordered.skeleton, places);
    }
  });
  return reordered;
}

}  // namespace throng::anim
