// A character whose bones change their order is to the bit the one that is baked in that order, though no clip is
// baked.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/sampled_rows.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/survey/lod_survey.h"
#include "tests/anim/asset/clip_fixtures.h"
#include "tests/anim/bake/clip_parts.h"

namespace throng::anim::reorder_test {
namespace {

template <typename Stream>
bool same_bits(const Stream* a, const Stream* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a->total_size == b->total_size && std::memcmp(a, b, a->total_size) == 0;
}

void expect_same(const Character& a, const Character& b) {
  EXPECT_EQ(a.data_key_names, b.data_key_names);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.level_entries, b.level_entries);
  EXPECT_EQ(a.bounds.reach, b.bounds.reach);
  EXPECT_EQ(a.morph_bones, b.morph_bones);
  EXPECT_EQ(a.morph_reach, b.morph_reach);
  EXPECT_EQ(a.bone_lod.level_error_metres, b.bone_lod.level_error_metres);
  for (std::size_t bone = 0; bone < a.bone_lod.rows.size(); ++bone) {
    EXPECT_EQ(a.bone_lod.rows[bone].error_metres, b.bone_lod.rows[bone].error_metres) << bone;
    EXPECT_EQ(a.bone_lod.rows[bone].level, b.bone_lod.rows[bone].level) << bone;
  }
  ASSERT_EQ(a.surface_points.firsts, b.surface_points.firsts);
  for (std::size_t i = 0; i < a.surface_points.influences.size(); ++i) {
    EXPECT_EQ(a.surface_points.influences[i].entry, b.surface_points.influences[i].entry);
    EXPECT_EQ(a.surface_points.influences[i].weighted, b.surface_points.influences[i].weighted);
  }
  ASSERT_EQ(a.entry_boxes.size(), b.entry_boxes.size());
  for (std::size_t entry = 0; entry < a.entry_boxes.size(); ++entry) {
    EXPECT_EQ(a.entry_boxes[entry].low, b.entry_boxes[entry].low) << entry;
    EXPECT_EQ(a.entry_boxes[entry].high, b.entry_boxes[entry].high) << entry;
  }
  ASSERT_EQ(a.clips.size(), b.clips.size());
  for (std::size_t clip = 0; clip < a.clips.size(); ++clip) {
    EXPECT_TRUE(same_bits(a.clips[clip].keyframe(), b.clips[clip].keyframe())) << clip;
    EXPECT_TRUE(same_bits(a.clips[clip].sampled(), b.clips[clip].sampled())) << clip;
    EXPECT_EQ(a.clips[clip].loops, b.clips[clip].loops);
    EXPECT_EQ(a.clips[clip].closing_step, b.clips[clip].closing_step);
    EXPECT_EQ(a.clips[clip].loop_displacement, b.clips[clip].loop_displacement);
    EXPECT_EQ(a.clips[clip].sampled_rate, b.clips[clip].sampled_rate);
    EXPECT_EQ(a.clips[clip].sampled_error, b.clips[clip].sampled_error);
    EXPECT_EQ(a.clips[clip].note, b.clips[clip].note);
    EXPECT_EQ(a.clips[clip].morphs.size(), b.clips[clip].morphs.size());
    EXPECT_EQ(a.skip_errors[clip].blended, b.skip_errors[clip].blended);
    EXPECT_EQ(a.skip_errors[clip].held, b.skip_errors[clip].held);
  }
}

void expect_same_as_baked_anew(const Model& given) {
  Model model = given;
  const BoneOrder order = other_order(model.skeleton);
  const Character character = bake_character(model);
  reorder_bones(model, order);
  const Character anew = bake_character(model);
  keep_surveyed_keys(model);
  expect_same(reorder_character(character, model, order), anew);
}

TEST(ReorderedCharacter, IsTheOneThatIsBakedInThatOrder) {
  expect_same_as_baked_anew(synthetic_model(62, 3));
  Model without_clips = synthetic_model(40, 1);
  without_clips.clips.clear();
  for (Model model : {general_model(40), without_clips}) {
    unsigned seed = 0;
    for (const Interpolation kind : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline}) {
      model.clips.push_back(wild_clip(model.skeleton, kind, 1.5, ++seed));
    }
    expect_same_as_baked_anew(model);
  }
}

/// Each bone holds a vertex that a morph of its own moves.
Model with_morphs(Model model) {
  SkinnedMesh& mesh = model.meshes.emplace_back();
  for (int entry = 0; entry < model.skeleton.palette_count(); ++entry) {
    mesh.positions.emplace_back(0.0F, 0.1F * static_cast<float>(entry), 0.0F);
    mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
    mesh.palette_entries.emplace_back(entry, entry, entry, entry);
    mesh.weights.emplace_back(1.0F, 0.0F, 0.0F, 0.0F);
    const auto morph = static_cast<std::uint32_t>(entry);
    mesh.morph_deltas.push_back({.vertex = morph, .morph = morph, .position = {0.0F, 0.5F, 0.0F}, .normal = {}});
  }
  model.morphs.resize(mesh.positions.size());
  model.clips.front().morph_tracks = {
      {.interpolation = Interpolation::linear, .morphs = {1}, .times = {0.0F}, .weights = {1.0F}}};
  return model;
}

TEST(ReorderedCharacter, KeepsItsMorphsAndTheirBones) {
  expect_same_as_baked_anew(with_morphs(synthetic_model(30, 2)));
}

/// STEP, LINEAR and CUBICSPLINE tracks in one clip.
TEST(ReorderedCharacter, KeepsEveryInterpolation) {
  Model model = synthetic_model(20, 1);
  for (BoneTracks& tracks : model.clips.front().tracks) {
    Track<glm::quat>& rotation = tracks.rotation;
    if (tracks.bone % 3 == 0) rotation.interpolation = Interpolation::step;
    if (tracks.bone % 3 != 1) continue;
    rotation.interpolation = Interpolation::cubic_spline;
    std::vector<glm::quat> values;
    for (const glm::quat& value : rotation.values) values.insert(values.end(), {value * 0.1F, value, value * 0.2F});
    rotation.values = std::move(values);
  }
  expect_same_as_baked_anew(model);
}

/// Returns the farthest that a rotation or position of a bone in one clip is from that of another, in the same row.
/// Both clips have the same rows.
double farthest_row(const SampledStream& a, const SampledStream& b) {
  const SampledRows rows = rows_of(a), others = rows_of(b);
  double farthest = rows.rows.size() == others.rows.size() ? 0.0 : 1e9;
  for (std::size_t i = 0; i < rows.rows.size() && farthest < 1e9; ++i) {
    farthest = std::max(farthest, static_cast<double>(std::abs(rows.rows[i] - others.rows[i])));
  }
  return farthest;
}

/// All bones but the root slide along an axis of their own, and do not come back: the clip lacks the key that closes
/// it.
Model sliding_model() {
  Model model = synthetic_model(30, 1);
  model.clips.front().duration = 1.0;
  for (BoneTracks& tracks : model.clips.front().tracks) {
    const glm::vec3 rest = model.skeleton.bones[static_cast<std::size_t>(tracks.bone)].rest.translation;
    const auto slide = [&](float time) {
      glm::vec3 place = rest;
      if (tracks.bone > 0) place[tracks.bone % 3] += 0.1F * std::sin(6.2831853F * time * 30.0F / 31.0F);
      return place;
    };
    tracks.translation = sampled_track(slide, 30.0, 30);
  }
  return model;
}

TEST(ReorderedCharacter, KeepsWhereBonesSlideTo) { expect_same_as_baked_anew(sliding_model()); }

TEST(ReorderedCharacter, ComesFromTheRowsWhereKeysWereLetGo) {
  for (const Model& model : {synthetic_model(62, 3), general_model(40), sliding_model()}) {
    Model other = model;
    if (other.clips.empty()) other.clips.push_back(wild_clip(other.skeleton, Interpolation::linear, 1.5, 1));
    const Character with_keys = bake_character(other);
    Character without = bake_character(other);
    keep_played_streams(without);
    const BoneOrder order = other_order(other.skeleton);
    reorder_bones(other, order);
    const Character expected = reorder_character(with_keys, other, order);
    const Character reordered = reorder_character(without, other, order);
    for (std::size_t clip = 0; clip < expected.clips.size(); ++clip) {
      if (expected.clips[clip].sampled() == nullptr) continue;
      EXPECT_EQ(reordered.clips[clip].keyframe(), nullptr);
      EXPECT_LT(farthest_row(*reordered.clips[clip].sampled(), *expected.clips[clip].sampled()), 1e-4) << clip;
    }
  }
}

TEST(ReorderedCharacter, ErrsAsItsWorstDroppedLimbWhereNoKeysTellMore) {
  Model model = synthetic_model(30, 2);
  const Character character = bake_character(model);
  const BoneOrder order = other_order(model.skeleton);
  reorder_bones(model, order);
  model.clips.clear();
  const Character reordered = reorder_character(character, model, order);
  ASSERT_GT(model.skeleton.level_bone_counts.size(), 1U);
  const auto kept = static_cast<std::size_t>(model.skeleton.level_bone_counts[1]);
  for (std::size_t bone = kept; bone < 30; ++bone) {
    EXPECT_LE(reordered.bone_lod.rows[bone].error_metres, reordered.bone_lod.level_error_metres[1]) << bone;
  }
  EXPECT_GT(reordered.bone_lod.level_error_metres[1], 0.0F);
}

TEST(KeepPlayedStreams, LetsTheKeysGoOfClipsThatHaveRows) {
  Model model = synthetic_model(20, 1);
  model.clips.push_back(wild_clip(model.skeleton, Interpolation::step, 1.5, 1));
  Character character = bake_character(model);
  ASSERT_EQ(character.clips[1].sampled(), nullptr) << "it jumps, and plays from its keys";
  keep_played_streams(character);
  EXPECT_EQ(character.clips[0].keyframe(), nullptr);
  EXPECT_NE(character.clips[1].keyframe(), nullptr);
  EXPECT_EQ(fault_of(character), nullptr);
}

TEST(SurveyedKeys, AreFewAndShowTheSamePoses) {
  Model model = synthetic_model(30, 2, 1, 120);
  const auto keys = [&] {
    std::size_t count = 0;
    for (const Clip& clip : model.clips) {
      for (const BoneTracks& tracks : clip.tracks) count += tracks.rotation.times.size();
    }
    return count;
  };
  std::vector<glm::dmat4> before, after;
  const auto into = [](std::vector<glm::dmat4>& all) {
    return [&all](std::span<const glm::dmat4> palette) { all.insert(all.end(), palette.begin(), palette.end()); };
  };
  const std::size_t all_keys = keys();
  visit_surveyed_poses(model, into(before));
  keep_surveyed_keys(model);
  visit_surveyed_poses(model, into(after));
  EXPECT_EQ(before, after);
  EXPECT_LT(keys(), all_keys / 2);
}

}  // namespace
}  // namespace throng::anim::reorder_test
