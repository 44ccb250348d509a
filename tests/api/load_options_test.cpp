// Options that say what a file leaves open: parts of the body, and loops without their last key.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/api/character_data.h"
#include "engine/anim/rig/rig_map.h"
#include "tests/api/api_crowd.h"
#include "tests/own_folder.h"

namespace throng::load_options_test {
namespace {

using api_test::mannequin;
using testing::Contains;
using testing::HasSubstr;

const std::string model = THRONG_SOURCE_DIR "/assets/mannequin.glb";

/// A bone that swings to and fro in a second of 30 steps, with or without the key that repeats the first.
CharacterBuilder swing(bool is_closed) {
  CharacterBuilder builder("swing");
  builder.add_bone({.name = "root"});
  builder.add_bone({.name = "tip", .parent = 0, .rest = {.translation = {0.0F, 1.0F, 0.0F}}});
  const int keys = is_closed ? 31 : 30;
  std::vector<float> seconds;
  std::vector<Quat> turns;
  for (int key = 0; key < keys; ++key) {
    const float angle = 0.4F * std::sin(6.2831853F * static_cast<float>(key) / 30.0F);
    seconds.push_back(static_cast<float>(key) / 30.0F);
    turns.push_back({.z = std::sin(0.5F * angle), .w = std::cos(0.5F * angle)});
  }
  const int clip = builder.add_clip("swing", static_cast<double>(seconds.back()));
  builder.set_rotations(clip, 0, {.seconds = seconds, .values = turns});
  return builder;
}

TEST(CloseLoops, LetsAClipRepeatThatLacksItsLastKey) {
  const auto closed = swing(false).build({.close_loops = true});
  ASSERT_TRUE(closed) << closed.error().message;
  const ClipInfo clip = closed->characters.front().clip({0});
  EXPECT_TRUE(clip.loops);
  EXPECT_NEAR(to_seconds(clip.duration), 1.0, 1e-4);
  EXPECT_TRUE(closed->notes.empty());
}

TEST(CloseLoops, AreNamedWhereTheyStayOpen) {
  const auto open = swing(false).build();
  EXPECT_FALSE(open->characters.front().clip({0}).loops);
  EXPECT_THAT(open->notes, Contains(HasSubstr("LoadOptions::close_loops closes them where a file has keys: swing")));
  EXPECT_TRUE(swing(true).build()->notes.empty());
}

TEST(CloseLoops, AreNamedInAPackTooWhereTheyStayOpen) {
  const test::OwnFolder folder;
  const std::string pack = folder.path() / "swing.pack";
  ASSERT_TRUE(save(pack, swing(false).build()->characters));
  EXPECT_THAT(load(pack)->notes, Contains(HasSubstr("clips do not loop")));
}

TEST(CloseLoops, LeaveALoopAsItIs) {
  const auto loop = swing(true).build({.close_loops = true});
  EXPECT_EQ(loop->characters.front().clip({0}).duration, swing(true).build()->characters.front().clip({0}).duration);
}

TEST(Rig, GivesBonesThePartsThatTheirNamesDoNotTell) {
  const std::vector<anim::Bone>& bones = mannequin().data()->baked->skeleton.bones;
  CharacterBuilder builder("nameless");
  std::vector<std::string> names;
  for (std::size_t bone = 0; bone < bones.size(); ++bone) names.push_back("bone " + std::to_string(bone));
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    const anim::Transform& rest = bones[bone].rest;
    builder.add_bone({.name = names[bone],
                      .parent = bones[bone].parent,
                      .rest = {{rest.translation.x, rest.translation.y, rest.translation.z},
                               {rest.rotation.x, rest.rotation.y, rest.rotation.z, rest.rotation.w},
                               {rest.scale.x, rest.scale.y, rest.scale.z}}});
  }
  std::vector<BoneRole> rig;
  const anim::RigMap parts = anim::find_rig(mannequin().data()->baked->skeleton);
  for (std::size_t role = 0; role < anim::body_role_count; ++role) {
    if (parts.bones[role] < 0) continue;
    rig.push_back({anim::body_role_names[role], names[static_cast<std::size_t>(parts.bones[role])]});
  }
  const auto without = builder.build(), with = builder.build({.rig = rig});
  ASSERT_TRUE(with) << with.error().message;
  EXPECT_THAT(without->characters.front().missing_rigs(), Contains(HasSubstr("cannot look at things")));
  EXPECT_TRUE(with->characters.front().missing_rigs().empty()) << with->characters.front().missing_rigs().front();
}

TEST(Rig, OfABoneOrPartThatThereIsNotIsAnError) {
  const BoneRole no_bone[] = {{"head", "skull"}}, no_part[] = {{"tail", "head"}};
  EXPECT_THAT(load(model, {.rig = no_bone}).error().message,
              HasSubstr("mannequin.glb: LoadOptions::rig: no skeleton has a bone named \"skull\""));
  EXPECT_THAT(load(model, {.rig = no_part}).error().message,
              HasSubstr("LoadOptions::rig: VRM 1.0 has no part of the body named \"tail\""));
}

TEST(Rig, OfACharacterThatIsBuiltIsAnErrorTooWhereThereIsNoSuchBone) {
  const BoneRole no_bone[] = {{"head", "skull"}};
  const auto built = swing(true).build({.rig = no_bone});
  ASSERT_FALSE(built);
  EXPECT_THAT(built.error().message, HasSubstr("swing: LoadOptions::rig: no skeleton has a bone named \"skull\""));
}

TEST(Rig, TakesThePartFromTheBoneThatHadIt) {
  CharacterBuilder builder = swing(true);
  builder.add_bone({.name = "top", .parent = 1, .role = "head"});
  const BoneRole rig[] = {{"head", "tip"}};
  const auto built = builder.build({.rig = rig});
  ASSERT_TRUE(built) << built.error().message;
  const Character& character = built->characters.front();
  const auto& bones = character.data()->baked->skeleton.bones;
  EXPECT_EQ(bones[static_cast<std::size_t>(*character.find_bone("tip"))].role, anim::BodyRole::head);
  EXPECT_EQ(bones[static_cast<std::size_t>(*character.find_bone("top"))].role, std::nullopt);
}

TEST(Rig, IsGivenToTheCharactersOfAPack) {
  const test::OwnFolder folder;
  const std::string pack = folder.path() / "man.pack";
  ASSERT_TRUE(save(pack, {&mannequin(), 1}));
  const BoneRole rig[] = {{"head", "neck"}}, no_bone[] = {{"head", "skull"}};
  const auto loaded = load(pack, {.rig = rig});
  ASSERT_TRUE(loaded) << loaded.error().message;
  const Character& character = loaded->characters.front();
  const auto& bones = character.data()->baked->skeleton.bones;
  EXPECT_EQ(bones[static_cast<std::size_t>(*character.find_bone("neck"))].role, anim::BodyRole::head);
  const auto without = load(pack, {.rig = no_bone});
  ASSERT_FALSE(without);
  EXPECT_THAT(without.error().message, HasSubstr("man.pack: LoadOptions::rig: no skeleton has a bone named \"skull\""));
}

TEST(Rig, WinsOverWhatNamesTell) {
  const BoneRole rig[] = {{"head", "neck"}};
  const Character headless = load(model, {.rig = rig})->characters.front();
  const auto& bones = headless.data()->baked->skeleton.bones;
  EXPECT_EQ(bones[static_cast<std::size_t>(*headless.find_bone("neck"))].role, anim::BodyRole::head);
}

}  // namespace
}  // namespace throng::load_options_test
