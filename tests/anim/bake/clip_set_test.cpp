// Clips come and go: each step makes another character, and none is changed.

#include "engine/anim/bake/clip_set.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/bake/clip_parts.h"

namespace throng::anim::clip_set_test {
namespace {

using Shared = std::shared_ptr<const Character>;

Shared shared(Character character) { return std::make_shared<const Character>(std::move(character)); }
Shared baked(const Model& model) { return shared(bake_character(model)); }

template <typename Stream>
bool same_bits(const Stream* a, const Stream* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a->total_size == b->total_size && std::memcmp(a, b, a->total_size) == 0;
}

void expect_same_clips(const Character& a, const Character& b) {
  ASSERT_EQ(a.clips.size(), b.clips.size());
  for (std::size_t clip = 0; clip < a.clips.size(); ++clip) {
    EXPECT_EQ(a.clips[clip].name, b.clips[clip].name);
    EXPECT_EQ(a.clips[clip].duration, b.clips[clip].duration);
    EXPECT_EQ(a.clips[clip].loop_displacement, b.clips[clip].loop_displacement);
    EXPECT_TRUE(same_bits(a.clips[clip].keyframe(), b.clips[clip].keyframe())) << clip;
    EXPECT_TRUE(same_bits(a.clips[clip].sampled(), b.clips[clip].sampled())) << clip;
  }
}

/// Returns what was made, shared.
Shared made(Result<Character> result) {
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return shared(std::move(*result));
}

std::string error_of(const Result<Character>& result) { return result ? "" : result.error().message; }

TEST(AddedClips, AreThoseOfACharacterThatWasBakedWithAll) {
  const Model whole = named_model(40, 5);
  const auto added = with_clips(baked(part_of(whole, 0, 3)), baked(part_of(whole, 3, 5)));
  ASSERT_TRUE(added) << error_of(added);
  EXPECT_EQ(fault_of(*added), nullptr);
  expect_same_clips(*added, bake_character(whole));
}

TEST(AddedClips, PlayFromTheBytesThatTheyCameWith) {
  const Model whole = named_model(30, 4);
  const Shared base = baked(part_of(whole, 0, 2)), more = baked(part_of(whole, 2, 4));
  const auto added = with_clips(base, more);
  ASSERT_TRUE(added) << error_of(added);
  EXPECT_EQ(added->clips[1].keyframe(), base->clips[1].keyframe());
  EXPECT_EQ(added->clips[2].sampled(), more->clips[0].sampled());
}

TEST(AddedClips, OfASkeletonInAnotherOrderArePutInOrder) {
  const Model whole = named_model(40, 4);
  Model turned = part_of(whole, 2, 4);
  reorder_bones(turned, other_order(turned.skeleton));
  ASSERT_NE(turned.skeleton.bones[5].name, whole.skeleton.bones[5].name);
  const auto added = with_clips(baked(part_of(whole, 0, 2)), baked(turned));
  ASSERT_TRUE(added) << error_of(added);
  expect_same_clips(*added, bake_character(whole));
}

TEST(AddedClips, AreCoveredByBoundsAndErrors) {
  const Model whole = named_model(40, 5);
  const Shared base = baked(part_of(whole, 0, 2)), more = baked(part_of(whole, 2, 5));
  const auto added = with_clips(base, more);
  ASSERT_TRUE(added) << error_of(added);
  for (const Shared& one : {base, more}) {
    EXPECT_GE(added->bounds.reach, one->bounds.reach);
    for (std::size_t level = 0; level < max_bone_levels; ++level) {
      EXPECT_GE(added->bone_lod.level_error_metres[level], one->bone_lod.level_error_metres[level]);
    }
  }
  EXPECT_GE(added->bounds.reach, bake_character(whole).bounds.reach);
  ASSERT_EQ(added->skip_errors.size(), 5U);
  EXPECT_EQ(added->skip_errors[1].held, base->skip_errors[1].held);
  EXPECT_EQ(added->skip_errors[4].held, more->skip_errors[2].held);
}

TEST(AddedClips, OfAnotherOrderAreCoveredByTheWorstLimbThatALevelDrops) {
  const Model whole = named_model(40, 4);
  Model turned = part_of(whole, 0, 2);
  reorder_bones(turned, other_order(turned.skeleton));
  const Shared more = baked(part_of(whole, 2, 4));
  const auto added = with_clips(baked(turned), more);
  ASSERT_TRUE(added) << error_of(added);
  ASSERT_EQ(added->skeleton.level_bone_counts.size(), 2U);
  int dropped = 0;
  for (std::size_t bone = 0; bone < more->skeleton.bones.size(); ++bone) {
    if (find_bone(added->skeleton, more->skeleton.bones[bone].name) < added->skeleton.level_bone_counts[1]) continue;
    EXPECT_GE(added->bone_lod.level_error_metres[1], more->bone_lod.rows[bone].error_metres);
    ++dropped;
  }
  EXPECT_EQ(dropped, 20);
}

TEST(AddedClips, OfFewerBonesThatAreDrawnReachAsFarAsTheSurface) {
  Model base = named_model(20, 1);
  SkinnedMesh& mesh = base.meshes.emplace_back();
  mesh.positions = {{0.0F, 0.0F, 40.0F}};
  mesh.normals = {{0.0F, 1.0F, 0.0F}};
  mesh.palette_entries = {{0, 0, 0, 0}};
  mesh.weights = {{1.0F, 0.0F, 0.0F, 0.0F}};
  Model more = part_of(named_model(20, 2), 1, 2);
  const Shared drawn = baked(base), joints = baked(more);
  const auto added = with_clips(drawn, joints);
  ASSERT_TRUE(added) << error_of(added);
  EXPECT_GE(added->bounds.reach, joints->bounds.reach + 39.0);
}

TEST(AddedClips, KeepTheNamesOfTheirKeysAndCurves) {
  const Model whole = named_model(20, 3);
  Character base = bake_character(part_of(whole, 0, 2)), more = bake_character(part_of(whole, 2, 3));
  base.data_key_names = {"step", "shot"};
  base.clips[0].data_keys = {{.time = Ticks{1}, .name = 1}};
  base.curve_names = {"speed"};
  more.data_key_names = {"word", "step"};
  more.clips[0].data_keys = {{.time = Ticks{1}, .name = 0}, {.time = Ticks{2}, .name = 1}};
  more.curve_names = {"light", "speed"};
  more.clips[0].curves = {{.name = 1, .times = {Ticks{}}, .values = {3.0F}}};
  const auto added = with_clips(shared(std::move(base)), shared(std::move(more)));
  ASSERT_TRUE(added) << error_of(added);
  EXPECT_EQ(added->data_key_names, (std::vector<std::string>{"step", "shot", "word"}));
  EXPECT_EQ(added->curve_names, (std::vector<std::string>{"speed", "light"}));
  EXPECT_EQ(added->clips[0].data_keys[0].name, 1U);
  EXPECT_EQ(added->clips[2].data_keys[0].name, 2U);
  EXPECT_EQ(added->clips[2].data_keys[1].name, 0U);
  EXPECT_EQ(added->clips[2].curves[0].name, 0U);
}

TEST(AddedClips, MoveTheSurfaceIfBothCharactersHaveTheSameMorphs) {
  const Model whole = named_model(20, 2);
  const auto with_morph = [&](int first, double reach) {
    Character character = bake_character(part_of(whole, first, first + 1));
    character.morph_bones = {3};
    character.morph_reach = reach;
    character.clips[0].morphs = {{.morphs = {0}, .times = {Ticks{}}, .weights = {1.0F}}};
    return shared(std::move(character));
  };
  const auto same = with_clips(with_morph(0, 0.25), with_morph(1, 0.25));
  const auto another = with_clips(with_morph(0, 0.25), with_morph(1, 0.5));
  ASSERT_TRUE(same && another);
  EXPECT_EQ(same->clips[1].morphs.size(), 1U);
  EXPECT_TRUE(another->clips[1].morphs.empty());
  EXPECT_EQ(another->clips[0].morphs.size(), 1U);
}

TEST(AddedClips, OfAnotherSkeletonAreRefusedWithTheFirstBoneThatDiffers) {
  const Model whole = named_model(20, 2);
  const Shared base = baked(part_of(whole, 0, 1));
  const auto refused = [&](auto change) {
    Model model = part_of(whole, 1, 2);
    model.skeleton.name = "guest";
    change(model.skeleton);
    return error_of(with_clips(base, baked(model)));
  };
  const std::string bone = whole.skeleton.bones[7].name;
  const std::string begin = "\"guest\" has not the skeleton of \"" + base->skeleton.name + "\": ";
  EXPECT_EQ(refused([](Skeleton& skeleton) { skeleton.bones[7].name = "tail"; }),
            begin + "\"tail\" is not in \"" + base->skeleton.name + '"');
  EXPECT_EQ(refused([](Skeleton& skeleton) { skeleton.bones[7].parent = 0; }),
            begin + '"' + bone + "\" has another parent");
  EXPECT_NE(refused([](Skeleton& skeleton) { skeleton.references[7].origin.x += 0.1; }).find("another bind pose"),
            std::string::npos);
  EXPECT_NE(error_of(with_clips(base, baked(named_model(19, 1)))).find("is not in"), std::string::npos);
  EXPECT_NE(error_of(with_clips(base, baked(named_model(21, 1)))).find("is not in"), std::string::npos);
}

TEST(AddedClips, OfABindPoseThatWasRoundedAreTaken) {
  const Model whole = named_model(20, 2);
  Model rounded = part_of(whole, 1, 2);
  rounded.skeleton.references[7].origin.x += 1e-6;
  EXPECT_EQ(error_of(with_clips(baked(part_of(whole, 0, 1)), baked(rounded))), "");
}

TEST(AddedClips, OfANameThatIsThereAreRefused) {
  const Model whole = named_model(20, 2);
  const Shared base = baked(whole);
  EXPECT_NE(error_of(with_clips(base, baked(part_of(whole, 1, 2)))).find("has a clip \"clip 1\" already"),
            std::string::npos);
  EXPECT_NE(error_of(with_clips(base, nullptr)), "");
  EXPECT_NE(error_of(with_clips(base, std::make_shared<const Character>())), "");
}

TEST(RemovedClips, LeaveAnEmptyPlaceThatTheNextClipFills) {
  const Model whole = named_model(20, 5);
  const Shared base = baked(part_of(whole, 0, 3));
  const auto without = without_clip(base, 1);
  ASSERT_TRUE(without) << error_of(without);
  EXPECT_EQ(fault_of(*without), nullptr);
  ASSERT_EQ(without->clips.size(), 3U);
  EXPECT_TRUE(without->clips[1].is_empty());
  EXPECT_EQ(without->clips[1].name, "");
  EXPECT_EQ(without->clips[1].generation, 1U);
  EXPECT_EQ(without->clips[2].keyframe(), base->clips[2].keyframe()) << "the others keep their numbers";
  EXPECT_EQ(without->clips[1].ground_speed(), 0.0);

  const auto filled = with_clips(made(without_clip(base, 1)), baked(part_of(whole, 3, 5)));
  ASSERT_TRUE(filled) << error_of(filled);
  ASSERT_EQ(filled->clips.size(), 4U);
  EXPECT_EQ(filled->clips[1].name, "clip 3");
  EXPECT_EQ(filled->clips[1].generation, 1U);
  EXPECT_EQ(filled->clips[3].name, "clip 4");
  EXPECT_EQ(filled->clips[3].generation, 0U);
}

TEST(RemovedClips, AreNeverTheLast) {
  const Model whole = named_model(20, 2);
  const auto one = without_clip(baked(whole), 0);
  ASSERT_TRUE(one);
  const Shared left = made(without_clip(baked(whole), 0));
  EXPECT_NE(error_of(without_clip(left, 1)).find("\"clip 1\" is the last clip"), std::string::npos);
  for (const int none : {-1, 0, 2})
    EXPECT_NE(error_of(without_clip(left, none)).find("no clip at place"), std::string::npos);
}

TEST(RemovedClips, LetGoOfTheFileThatTheyCameFromWithTheLastOfIt) {
  const Model whole = named_model(20, 4);
  for (const bool in_order : {true, false}) {
    Model other = part_of(whole, 2, 4);
    if (!in_order) reorder_bones(other, other_order(other.skeleton));
    std::weak_ptr<const Character> file;
    Shared played;
    {
      const Shared more = baked(other);
      file = more;
      played = made(with_clips(baked(part_of(whole, 0, 2)), more));
    }
    EXPECT_EQ(file.expired(), !in_order) << "streams in another order are a copy";
    played = made(without_clip(played, 2));
    EXPECT_EQ(file.expired(), !in_order) << "a clip of it is left";
    const std::weak_ptr<const void> last = played->clips[3].lender;
    EXPECT_FALSE(last.expired());
    played = made(without_clip(played, 3));
    EXPECT_TRUE(file.expired());
    EXPECT_TRUE(last.expired());
  }
}

TEST(RemovedClips, AndAddedOnesAHundredTimesTakeNoMorePlacesOrNames) {
  const Model whole = named_model(20, 4);
  Shared played = baked(part_of(whole, 0, 2));
  const std::weak_ptr<const Character> first = played;
  for (int round = 0; round < 100; ++round) {
    const Shared more = baked(part_of(whole, 2, 4));
    played = made(with_clips(played, more));
    for (const int clip : {2, 3}) played = made(without_clip(played, clip));
    ASSERT_EQ(played->clips.size(), 4U);
    ASSERT_EQ(more.use_count(), 1) << "round " << round;
  }
  EXPECT_EQ(played->clips[2].generation, 100U);
  EXPECT_EQ(first.use_count(), 2) << "two clips of it are left";
}

}  // namespace
}  // namespace throng::anim::clip_set_test
