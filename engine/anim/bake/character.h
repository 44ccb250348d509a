#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/data_keys.h"
#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/asset/morph_curves.h"
#include "engine/anim/asset/root_curve.h"
#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/asset/user_curves.h"
#include "engine/anim/bake/rounding.h"
#include "engine/anim/bake/skip_error.h"
#include "engine/anim/bake/stream_kind.h"
#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/base/box.h"
#include "engine/anim/base/units.h"
#include "engine/anim/kernel/palette/hierarchy.h"
#include "engine/anim/survey/bone_lod.h"
#include "engine/anim/survey/character_bounds.h"
#include "engine/anim/survey/surface_points.h"

namespace throng::anim {

/// A clip that is ready to play: its streams, and the results of baking. It has one stream at least. Without streams it
/// is an empty place: a clip was there, and another one may come (bake/clip_set.h).
struct BakedClip {
  std::string name;
  Ticks duration{};
  bool loops = false;    ///< first and last pose agree, without root motion
  Ticks closing_step{};  ///< above 0: a key that repeats the first, this long after the last, would close the clip
  glm::dvec3 loop_displacement{0.0};  ///< where a loop's root motion leads: metres, in the space of its start
  RootCurve root_motion;              ///< taken out of the pose, which stands where the curve is at its time
  std::vector<DataKey> data_keys;     ///< by time; names index Character::data_key_names
  UserCurves curves = {};             ///< numbers for game play; no pose depends on them
  MorphCurves morphs = {};            ///< empty: the surface keeps its shape
  /// Metres a second along x, to the left of a character that faces +Z, and along z, as the clip begins: its feet do
  /// not slide at that speed. A gait in place goes against its standing foot. 0: the clip is no gait.
  glm::dvec2 ground_velocity{0.0};
  AlignedBytes keyframe_block;  ///< null: it was let go (keep_played_streams), and the clip plays from `sampled_block`
  double keyframe_error = 0.0;  ///< metres by which still tracks and a turn taken out move the surface at most
  AlignedBytes sampled_block;   ///< null: the clip plays from its keyframe stream, and `note` says why
  double sampled_rate = 0.0;    ///< Hz
  double sampled_error = 0.0;   ///< metres, the largest measured on the surface proxy, `keyframe_error` included
  double error_bound = 0.0;     ///< metres: no stream is farther off than this
  Rounding sampled_rounding = Rounding::nearest;
  std::string note;
  std::uint32_t generation = 0;             ///< of its place: it grows when a clip leaves the place
  std::shared_ptr<const void> lender = {};  ///< keeps lent streams; null: this clip or Character::lender does

  bool is_empty() const { return keyframe_block == nullptr && sampled_block == nullptr; }
  double ground_speed() const { return glm::length(ground_velocity); }
  const KeyframeStream* keyframe() const { return reinterpret_cast<const KeyframeStream*>(keyframe_block.get()); }
  const SampledStream* sampled() const { return reinterpret_cast<const SampledStream*>(sampled_block.get()); }
};

struct BakeOptions {
  bool take_root_motion = true;  ///< remove travel, turn and climb of the root from the pose (off for `pose`)
  /// Time 0 is the file's, not the first key's, and tracks that hardly move keep their keys (for `pose`).
  bool as_in_the_file = false;
  /// Is called after each baked clip with the number of baked clips and of all clips. Any thread that bakes calls it,
  /// one at a time. Null: no call.
  std::function<void(std::size_t done, std::size_t clips)> progress = {};
};

/// A baked skeleton with its clips, and all that is measured on them. Read-only while agents play it.
struct Character {
  Skeleton skeleton;
  HierarchyProgram hierarchy;
  /// At least one of them has streams: a model without clips gets "rest", of its rest pose. Others may be empty places.
  std::vector<BakedClip> clips;
  std::vector<std::string> data_key_names = {};  ///< names in all its clips, each once
  std::vector<std::string> curve_names = {};     ///< names in all its clips, each once
  double height = 0.0;    ///< metres, of the rest pose's surface, or of its joints where there is no surface
  BoneLod bone_lod = {};  ///< the errors that dropping bones causes
  std::vector<SkipError> skip_errors = {};  ///< the errors that skipping frames causes, one a place
  CharacterBounds bounds = {};
  std::vector<int> morph_bones = {};              ///< of each of Model::morphs, the bone that it moves with
  double morph_reach = 0.0;                       ///< metres, how far these can move a vertex; bounds.reach has it too
  SurfacePoints surface_points = {};              ///< points where the errors of drawn poses are measured
  std::vector<Box> entry_boxes = {};              ///< [palette entry] of the surface that it moves, for bounds
  std::vector<std::uint32_t> level_entries = {};  ///< palette entries of each level, descending
  std::shared_ptr<const void> lender = {};        ///< keeps the memory that lent streams lie in, for example a pack
};

/// Returns why a system cannot play this character, in one sentence that lives as long as the program; null if it can.
const char* fault_of(const Character& character);

/// Bakes every clip of `model`, on as many threads as the machine has cores. Never fails on an imported model. A
/// model that check_model() refuses is a misuse: the character that comes of it has no bones, and no system takes it.
Character bake_character(const Model& model, const BakeOptions& options = {});

/// Returns the character that bake_character would make of `model`, which is the model of `character` in another order
/// of its bones. Takes the data that no order changes from `character` and does not bake clips again. Reads only those
/// keys of `model` that keep_surveyed_keys keeps.
Character reorder_character(const Character& character, const Model& model, const BoneOrder& order);

/// Frees the keyframe streams of clips that have a sampled stream. Agents play sampled streams, unless
/// SystemOptions::stream asks for keys. Other orders of the bones then come from the rows, which are rounded once more.
void keep_played_streams(Character& character);

/// Gives each gait that walks in place the root motion of its ground speed, straight in the direction of its steps. Its
/// poses stay as they are. reorder_character() would take this motion out of them, so it is called before.
void travel_by_steps(Character& character);

}  // namespace throng::anim
