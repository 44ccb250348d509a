// Building characters of a host's own data.

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/api/character_data.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "tests/api/api_crowd.h"
#include "tests/api/small_builder.h"

namespace throng::character_builder_test {
namespace {

using api_test::built;
using api_test::fault_of;
using api_test::small;
using testing::HasSubstr;

Vec3 as_own(const glm::vec3& v) { return {v.x, v.y, v.z}; }
Quat as_own(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

/// Tells a builder all of a model that import made.
CharacterBuilder told(const anim::Model& model) {
  CharacterBuilder builder(model.skeleton.name);
  for (const anim::Bone& bone : model.skeleton.bones) {
    builder.add_bone({.name = bone.name,
                      .parent = bone.parent,
                      .rest = {as_own(bone.rest.translation), as_own(bone.rest.rotation), as_own(bone.rest.scale)}});
  }
  for (const anim::Clip& clip : model.clips) {
    const int number = builder.add_clip(clip.name, clip.duration);
    for (const anim::BoneTracks& tracks : clip.tracks) {
      std::vector<Quat> turns;
      std::vector<Vec3> places;
      for (const glm::quat& turn : tracks.rotation.values) turns.push_back(as_own(turn));
      for (const glm::vec3& place : tracks.translation.values) places.push_back(as_own(place));
      builder.set_rotations(number, tracks.bone, {.seconds = tracks.rotation.times, .values = turns});
      builder.set_translations(number, tracks.bone, {.seconds = tracks.translation.times, .values = places});
    }
  }
  return builder;
}

/// Returns the joints of a bone at a time of clip 0, row by row.
std::array<float, 12> joint(const Character& character, std::string_view bone, Ticks time) {
  Crowd crowd = std::move(*Crowd::create(character));
  const int wanted[] = {character.find_bone(bone).value_or(0)};
  EXPECT_TRUE(crowd.write_joints(0, {.bones = wanted, .format = JointFormat::matrices}));
  alignas(64) std::array<float, 16> written{};
  const PoseRequest request{.agent = crowd.add_agent(), .joints = reinterpret_cast<std::byte*>(written.data())};
  crowd.agent(request.agent).play({.clip = {0}, .loop = false});
  crowd.advance(time);
  crowd.update({&request, 1});
  std::array<float, 12> rows{};
  std::copy_n(written.begin(), rows.size(), rows.begin());
  return rows;
}

TEST(CharacterBuilder, BuildsTheCharacterThatImportWouldHaveMade) {
  const anim::Model model = anim::synthetic_model(23, 2);
  const Character character = built(told(model));
  ASSERT_EQ(character.bone_count(), 23);
  ASSERT_EQ(character.clip_count(), 2U);
  EXPECT_EQ(character.clip({1}).name, "clip_1");
  const anim::Character baked = anim::bake_character(model);
  EXPECT_EQ(character.clip({1}).duration, baked.clips[1].duration);
  EXPECT_TRUE(character.data()->baked->skeleton.rigid);
  EXPECT_EQ(character.data()->baked->clips[0].sampled()->row_count, baked.clips[0].sampled()->row_count);
  EXPECT_NEAR(character.height(), baked.height, 1e-6);
}

TEST(CharacterBuilder, PosesBonesAsItsKeysSay) {
  CharacterBuilder builder = small();
  const float seconds[] = {0.0F, 1.0F};
  const Vec3 places[] = {{}, {2.0F, 0.0F, 0.0F}};
  const float half = std::sqrt(0.5F);
  const Quat turns[] = {{}, {.z = half, .w = half}};  // a quarter about z
  builder.set_translations(0, 0, {.seconds = seconds, .values = places});
  builder.set_rotations(0, 0, {.seconds = seconds, .values = turns});
  const auto tip = joint(built(builder), "tip", ticks_per_second);
  EXPECT_NEAR(tip[7], 0.0F, 1e-3F) << "the tip lies on the ground";
  EXPECT_NEAR(tip[1], -1.0F, 1e-3F) << "and has turned";
}

TEST(CharacterBuilder, TakesKeysThatScaleAndKeysThatStep) {
  CharacterBuilder builder = small();
  const float seconds[] = {0.0F, 0.5F};
  const Vec3 sizes[] = {{1.0F, 1.0F, 1.0F}, {1.0F, 3.0F, 1.0F}};
  builder.set_scales(0, 0, {.seconds = seconds, .values = sizes, .form = KeyForm::step});
  const Character character = built(builder);
  EXPECT_NEAR(joint(character, "tip", ticks_per_second / 4)[7], 1.0F, 1e-3F);
  EXPECT_NEAR(joint(character, "tip", ticks_per_second * 3 / 4)[7], 3.0F, 1e-3F);
}

TEST(CharacterBuilder, FollowsTheTangentsOfACubicKey) {
  CharacterBuilder builder = small();
  const float seconds[] = {0.0F, 1.0F};
  const Vec3 keys[] = {{}, {}, {4.0F, 0.0F, 0.0F}, {}, {}, {}};  // in-tangent, value and out-tangent of each
  builder.set_translations(0, 0, {.seconds = seconds, .values = keys, .form = KeyForm::cubic_spline});
  EXPECT_NEAR(joint(built(builder), "root", ticks_per_second / 2)[3], 0.5F, 1e-3F);
}

TEST(CharacterBuilder, KeepsDataKeysCurvesAndRoles) {
  CharacterBuilder builder = small();
  const float seconds[] = {0.0F, 1.0F}, values[] = {0.0F, 8.0F};
  builder.add_data_key(0, "late", 0.75);
  builder.add_data_key(0, "early", 0.25);
  builder.add_curve(0, "glow", seconds, values);
  builder.add_bone({.name = "x", .parent = 1, .role = "head"});
  const Character character = built(builder);
  Crowd crowd = std::move(*Crowd::create(character));
  const Agent agent = crowd.agent(crowd.add_agent());
  agent.play({.clip = {0}});
  crowd.advance(ticks_per_second / 2);
  std::vector<std::string> met;
  agent.motion().for_each_key(Ticks{}, ticks_per_second / 2,
                              [&](const DataKey& key) { met.push_back(character.data_key_names()[key.name]); });
  EXPECT_THAT(met, testing::ElementsAre("early"));
  agent.motion().for_each_key(ticks_per_second / 2, ticks_per_second * 9 / 10,
                              [&](const DataKey& key) { met.push_back(character.data_key_names()[key.name]); });
  EXPECT_THAT(met, testing::ElementsAre("early", "late"));
  EXPECT_NEAR(agent.motion().curve(0), 4.0F, 1e-3F);
  EXPECT_EQ(character.data()->baked->skeleton.bones[static_cast<std::size_t>(*character.find_bone("x"))].role,
            anim::BodyRole::head);
}

TEST(CharacterBuilder, TakesAnotherUnitByItsScale) {
  EXPECT_NEAR(built(small(), {.scale = 0.01}).height(), 0.01, 1e-6);
}

TEST(CharacterBuilder, WithoutClipsHasItsRestPose) {
  CharacterBuilder builder("still");
  builder.add_bone({.name = "root"});
  EXPECT_EQ(built(builder).clip({0}).name, "rest");
}

TEST(CharacterBuilder, NamesTheFirstFault) {
  EXPECT_THAT(fault_of(CharacterBuilder("empty")), HasSubstr("model \"empty\": it has no bones"));
  CharacterBuilder orphan = small();
  orphan.add_bone({.name = "orphan", .parent = 7});
  EXPECT_THAT(fault_of(orphan), HasSubstr("bone \"orphan\": its parent is not a bone before it"));
  CharacterBuilder role = small();
  role.add_bone({.name = "x", .parent = 0, .role = "paw"});
  EXPECT_THAT(fault_of(role), HasSubstr("bone \"x\": VRM 1.0 has no part of the body named \"paw\""));
  CharacterBuilder clip = small();
  clip.add_data_key(3, "key", 0.0);
  EXPECT_THAT(fault_of(clip), HasSubstr("small: there is no clip 3"));
  CharacterBuilder bone = small();
  bone.set_rotations(0, 9, {});
  EXPECT_THAT(fault_of(bone), HasSubstr("clip \"clip\": there is no bone 9"));
  CharacterBuilder late = small();
  const float seconds[] = {0.0F, 2.0F};
  const Quat turns[] = {{}, {}};
  late.set_rotations(0, 1, {.seconds = seconds, .values = turns});
  EXPECT_THAT(fault_of(late), HasSubstr("clip \"clip\": bone \"tip\": the clip's duration ends before a key"));
  CharacterBuilder few = small();
  few.set_rotations(0, 1, {.seconds = seconds, .values = std::span(turns).first(1)});
  EXPECT_THAT(fault_of(few), HasSubstr("a track does not have one value a key"));
  CharacterBuilder flat = small();
  flat.add_bone({.name = "flat", .parent = 0, .rest = {.scale = {0.0F, 1.0F, 1.0F}}});
  EXPECT_THAT(fault_of(flat), HasSubstr("bone \"flat\": its rest pose has a scale of 0"));
  CharacterBuilder bind = small();
  Mat4 lost{};
  lost.columns[3][0] = std::numeric_limits<float>::quiet_NaN();
  bind.add_bone({.name = "lost", .parent = 0, .inverse_bind = lost});
  EXPECT_THAT(fault_of(bind), HasSubstr("bone \"lost\": its inverse_bind is not of finite numbers"));
}

TEST(CharacterBuilder, MayBeMovedAndBuildsAsOftenAsOneLikes) {
  CharacterBuilder first = small();
  const CharacterBuilder moved = std::move(first);
  EXPECT_EQ(built(moved).bone_count(), 2);
  EXPECT_EQ(built(moved).bone_count(), 2);
}

}  // namespace
}  // namespace throng::character_builder_test
