#include "engine/anim/bake/clip_set.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/anim/bake/bone_match.h"
#include "engine/anim/bake/name_numbers.h"
#include "engine/anim/bake/reorder.h"
#include "engine/base/text/plain_text.h"

namespace throng::anim {
namespace {

using Owner = std::shared_ptr<const void>;

std::optional<Error> fault_in(const std::shared_ptr<const Character>& character) {
  if (character == nullptr) return Error{"the character is null"};
  const char* const fault = fault_of(*character);
  return fault == nullptr ? std::nullopt : std::optional(Error{in_quotes(character->skeleton.name) + ": " + fault});
}

/// Returns a clip with the streams of another one, which `owner` keeps unless another owner does.
BakedClip lend_clip(const BakedClip& clip, const Owner& owner) {
  BakedClip lent = without_streams(clip);
  if (clip.is_empty()) return lent;
  if (clip.keyframe_block != nullptr) lent.keyframe_block = lend_aligned(clip.keyframe_block.get());
  if (clip.sampled_block != nullptr) lent.sampled_block = lend_aligned(clip.sampled_block.get());
  lent.lender = clip.lender == nullptr ? owner : clip.lender;
  return lent;
}

/// Returns for each name of `more` its index in `names`, which take the new ones.
std::vector<std::uint32_t> join_names(std::vector<std::string>& names, const std::vector<std::string>& more) {
  NameNumbers numbers(names);
  std::vector<std::uint32_t> indices;
  indices.reserve(more.size());
  for (const std::string& name : more) indices.push_back(numbers.of(name));
  return indices;
}

/// Returns how far the surface lies from the joints that move it, at most.
double depth_of_surface(const Character& character) {
  double depth = 0.0;
  for (const PointInfluence& influence : character.surface_points.influences) {
    const JointPlace joint = joint_place(character.skeleton, character.skeleton.palette[influence.entry].bone);
    if (joint.entry != static_cast<int>(influence.entry) || influence.weighted.w <= 0.0F) continue;
    const glm::dvec3 position = glm::dvec3(influence.weighted) / static_cast<double>(influence.weighted.w);
    depth = std::max(depth, glm::distance(position, joint.position));
  }
  return depth;
}

/// Adds the clips of one character to a copy of another.
class ClipUnion {
 public:
  ClipUnion(const std::shared_ptr<const Character>& base, std::shared_ptr<const Character> more,
            std::vector<int> places)
      : result_(lend_character(base)),
        more_(std::move(more)),
        places_(std::move(places)),
        keys_(join_names(result_.data_key_names, more_->data_key_names)),
        curves_(join_names(result_.curve_names, more_->curve_names)),
        keeps_order_(std::ranges::is_sorted(places_)),
        keeps_morphs_(has_same_morphs()) {}

  Character add_all() {
    for (std::size_t clip = 0; clip < more_->clips.size(); ++clip) {
      if (!more_->clips[clip].is_empty()) add(clip);
    }
    widen_bounds();
    widen_bone_errors();
    return std::move(result_);
  }

 private:
  void add(std::size_t index) {
    BakedClip clip = take(more_->clips[index]);
    for (DataKey& key : clip.data_keys) key.name = keys_[key.name];
    for (UserCurve& curve : clip.curves) curve.name = curves_[curve.name];
    if (!keeps_morphs_) clip.morphs.clear();
    const auto place = std::ranges::find_if(result_.clips, &BakedClip::is_empty);
    const auto number = static_cast<std::size_t>(place - result_.clips.begin());
    clip.generation = place == result_.clips.end() ? 0 : place->generation;
    if (place == result_.clips.end()) {
      result_.clips.emplace_back();
      result_.skip_errors.emplace_back();
    }
    result_.clips[number] = std::move(clip);
    if (index < more_->skip_errors.size()) result_.skip_errors[number] = more_->skip_errors[index];
  }

  // A clip in another order is a value of its own, so that it keeps nothing else.
  BakedClip take(const BakedClip& clip) const {
    if (keeps_order_) return lend_clip(clip, more_);
    const auto own = std::make_shared<const BakedClip>(reorder_clip(clip, result_.skeleton, places_));
    return lend_clip(*own, own);
  }

  bool has_same_morphs() const {
    if (more_->morph_bones.size() != result_.morph_bones.size()) return false;
    for (std::size_t morph = 0; morph < result_.morph_bones.size(); ++morph) {
      if (places_[static_cast<std::size_t>(more_->morph_bones[morph])] != result_.morph_bones[morph]) return false;
    }
    return std::abs(more_->morph_reach - result_.morph_reach) <= 1e-6 * result_.morph_reach;
  }

  // Both spheres stand on the ground. A surface of the same height is taken for the same one.
  void widen_bounds() {
    CharacterBounds& bounds = result_.bounds;
    const bool has_same_surface = std::abs(more_->height - result_.height) <= 1e-6 * result_.height;
    const double beyond = has_same_surface ? 0.0 : depth_of_surface(result_) + result_.morph_reach;
    const double apart = std::abs(more_->bounds.height - bounds.height) / 2.0;
    bounds.reach = std::max(bounds.reach, more_->bounds.reach + apart + beyond);
  }

  void widen_bone_errors() {
    BoneLod& lod = result_.bone_lod;
    const BoneLod& other = more_->bone_lod;
    if (lod.rows.size() != places_.size() || other.rows.size() != places_.size()) return;
    for (std::size_t bone = 0; bone < places_.size(); ++bone) {
      float& error = lod.rows[static_cast<std::size_t>(places_[bone])].error_metres;
      error = std::max(error, other.rows[bone].error_metres);
    }
    for (std::size_t level = 1; level < lod.level_error_metres.size(); ++level) {
      lod.level_error_metres[level] =
          std::max({lod.level_error_metres[level], level_error(level), lod.level_error_metres[level - 1]});
    }
  }

  // Takes the error of the worst limb that a level drops, for clips that were not measured at this level.
  float level_error(std::size_t level) const {
    const std::vector<int>& counts = result_.skeleton.level_bone_counts;
    if (level >= counts.size()) return 0.0F;
    if (keeps_order_ && counts == more_->skeleton.level_bone_counts) return more_->bone_lod.level_error_metres[level];
    float error = 0.0F;
    for (std::size_t bone = 0; bone < places_.size(); ++bone) {
      if (places_[bone] >= counts[level]) error = std::max(error, more_->bone_lod.rows[bone].error_metres);
    }
    return error;
  }

  Character result_;
  std::shared_ptr<const Character> more_;
  std::vector<int> places_;
  std::vector<std::uint32_t> keys_;    // [name of a data key of more_] its index in the result
  std::vector<std::uint32_t> curves_;  // [name of a curve of more_] the same
  bool keeps_order_;
  bool keeps_morphs_;
};

}  // namespace

Character lend_character(const std::shared_ptr<const Character>& from) {
  Character lent{.skeleton = from->skeleton,
                 .hierarchy = from->hierarchy,
                 .clips = {},
                 .data_key_names = from->data_key_names,
                 .curve_names = from->curve_names,
                 .height = from->height,
                 .bone_lod = from->bone_lod,
                 .skip_errors = from->skip_errors,
                 .bounds = from->bounds,
                 .morph_bones = from->morph_bones,
                 .morph_reach = from->morph_reach,
                 .surface_points = from->surface_points,
                 .entry_boxes = from->entry_boxes,
                 .level_entries = from->level_entries};
  lent.skip_errors.resize(from->clips.size(), no_skip_error);
  for (const BakedClip& clip : from->clips) lent.clips.push_back(lend_clip(clip, from));
  return lent;
}

Result<Character> with_clips(const std::shared_ptr<const Character>& base, std::shared_ptr<const Character> more) {
  for (const auto& one : {base, more}) {
    if (auto fault = fault_in(one); fault) return std::move(*fault);
  }
  Result<std::vector<int>> places = match_bones(base->skeleton, more->skeleton);
  if (!places) return places.error();
  for (const BakedClip& clip : more->clips) {
    const auto found = std::ranges::find(base->clips, clip.name, &BakedClip::name);
    if (clip.is_empty() || found == base->clips.end()) continue;
    return Error{in_quotes(base->skeleton.name) + " has a clip " + in_quotes(clip.name) +
                 " already: take it away first, or give one of them another name"};
  }
  return ClipUnion(base, std::move(more), std::move(*places)).add_all();
}

Result<Character> without_clip(const std::shared_ptr<const Character>& from, int clip) {
  if (auto fault = fault_in(from); fault) return std::move(*fault);
  const auto place = static_cast<std::size_t>(clip);
  const std::vector<BakedClip>& clips = from->clips;
  if (clip < 0 || place >= clips.size() || clips[place].is_empty()) {
    return Error{in_quotes(from->skeleton.name) + " has no clip at place " + std::to_string(clip)};
  }
  if (clips.size() - 1 == static_cast<std::size_t>(std::ranges::count_if(clips, &BakedClip::is_empty))) {
    return Error{in_quotes(clips[place].name) + " is the last clip of " + in_quotes(from->skeleton.name) +
                 ": a character has at least one"};
  }
  Character without = lend_character(from);
  const std::uint32_t generation = without.clips[place].generation + 1;
  without.clips[place] = {};
  without.clips[place].generation = generation;
  without.skip_errors[place] = no_skip_error;
  return without;
}

}  // namespace throng::anim
