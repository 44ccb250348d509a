// Saving characters as a pack, and the memory of their keys.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/api/character_data.h"
#include "engine/anim/pack/archive.h"
#include "engine/anim/pack/pack.h"
#include "engine/anim/pack/tables.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"
#include "tests/api/small_builder.h"
#include "tests/api/smiling.h"
#include "tests/own_folder.h"

namespace throng::save_test {
namespace {

using anim::HeardMisuses;
using api_test::built;
using api_test::hash_of;
using api_test::mannequin;
using api_test::small;
using api_test::smiling;
using testing::HasSubstr;

const std::string model = THRONG_SOURCE_DIR "/assets/mannequin.glb";

/// Returns a character as load() gives it back after save().
Character saved_and_loaded(const Character& character, const LoadOptions& options = {}) {
  const test::OwnFolder folder;
  const std::string pack = folder.path() / "man.pack";
  const Status saved = save(pack, {&character, 1});
  EXPECT_TRUE(saved) << (saved ? "" : saved.error().message);
  const auto loaded = load(pack, options);
  EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().message);
  return loaded->characters.front();
}

std::size_t bytes_of_keys(const Character& character) {
  std::size_t bytes = 0;
  for (const anim::BakedClip& clip : character.data()->baked->clips) {
    if (clip.keyframe() != nullptr) bytes += clip.keyframe()->total_size;
  }
  return bytes;
}

TEST(Save, GivesBackACharacterThatPlaysToTheBit) {
  const Character back = saved_and_loaded(mannequin());
  ASSERT_EQ(back.clip_count(), mannequin().clip_count());
  for (const char* const clip : {"walk", "wave", "sit"}) {
    EXPECT_EQ(hash_of(back, back.find_clip(clip)), hash_of(mannequin(), mannequin().find_clip(clip))) << clip;
  }
  EXPECT_EQ(back.clip(back.find_clip("walk")).ground_speed,
            mannequin().clip(mannequin().find_clip("walk")).ground_speed);
  EXPECT_EQ(back.height(), mannequin().height());
}

std::vector<std::byte> tables_of(const Character& character) {
  pack::PackWriter writer;
  writer(*character.data()->baked);
  return writer.bytes();
}

TEST(Save, GivesBackAllThatWasBaked) {
  CharacterBuilder glows = small();
  const float seconds[] = {0.0F, 1.0F}, values[] = {0.0F, 8.0F};
  glows.add_curve(0, "glow", seconds, values);
  glows.add_bone({.name = "top", .parent = 1, .role = "head"});
  for (const Character& character : {mannequin(), smiling(), built(glows)}) {
    EXPECT_TRUE(tables_of(saved_and_loaded(character)) == tables_of(character)) << character.clip({0}).name;
  }
}

TEST(Save, KeepsMaterialsImagesAndMorphs) {
  const Character back = saved_and_loaded(smiling(), {.keep_meshes = true});
  EXPECT_THAT(back.morph_names(), testing::ElementsAre("smile"));
  ASSERT_EQ(back.mesh_count(), 1U);
  EXPECT_EQ(back.mesh(0).morph_deltas.size(), 1U);
  EXPECT_EQ(back.mesh(0).normal_scale, 0.5F);
  ASSERT_EQ(back.mesh(0).normal_texture.texels.size(), 4U);
  EXPECT_EQ(back.mesh(0).normal_texture.texels[1], 6);
}

TEST(Save, KeepsTheSurfaceThatWasKept) {
  const Character back = saved_and_loaded(mannequin(), {.keep_meshes = true});
  ASSERT_EQ(back.mesh_count(), mannequin().mesh_count());
  ASSERT_GT(back.mesh_count(), 0U);
  EXPECT_EQ(back.mesh(0).positions.size(), mannequin().mesh(0).positions.size());
  EXPECT_EQ(back.mesh(0).positions[5], mannequin().mesh(0).positions[5]);
  EXPECT_EQ(saved_and_loaded(mannequin()).mesh_count(), 0U);
}

/// Returns the hash of a rag-doll that falls for a second.
std::uint64_t hash_of_fall(const Character& character) {
  Crowd crowd = std::move(*Crowd::create(character, {.hash = true}));
  const PoseRequest request{.agent = crowd.add_agent()};
  const Agent agent = crowd.agent(request.agent);
  agent.play({.clip = character.find_clip("walk")});
  const auto doll = agent.add(Ragdoll{});
  EXPECT_TRUE(doll);
  crowd.update({&request, 1});
  agent.processes().push(*doll, {200.0F, 0.0F, 0.0F}, {0.0F, 1.3F, 0.0F});
  for (int frame = 0; frame < 30; ++frame) {
    crowd.advance(ticks_per_second / 30);
    crowd.update({&request, 1});
  }
  return crowd.debug().pose_hash();
}

TEST(Save, KeepsARagdollAsThickAsTheSurfaceThatIsNotSaved) {
  const Character bare = load(model)->characters.front();
  const Character back = saved_and_loaded(bare);
  EXPECT_EQ(back.mesh_count(), 0U);
  EXPECT_EQ(hash_of_fall(back), hash_of_fall(bare));
}

TEST(Save, LetsARagdollBeBuiltAnewOfTheRigThatIsNamedLater) {
  const test::OwnFolder folder;
  const std::string pack = folder.path() / "man.pack";
  ASSERT_TRUE(save(pack, {&mannequin(), 1}));
  const BoneRole rig[] = {{"leftLowerArm", "hand.L"}};
  const LoadOptions named{.keep_meshes = true, .rig = rig};
  const Character of_file = load(model, named)->characters.front(), of_pack = load(pack, named)->characters.front();
  ASSERT_NE(hash_of_fall(of_file), hash_of_fall(mannequin())) << "else the promise below could not be broken";
  EXPECT_EQ(hash_of_fall(of_pack), hash_of_fall(of_file));
}

TEST(Save, KeepsTheBoundsOfASurfaceThatIsNotSaved) {
  const Character bare = load(model)->characters.front();
  const Character back = saved_and_loaded(bare);
  const ClipId walk = bare.find_clip("walk");
  EXPECT_EQ(back.bounds(walk).high, bare.bounds(walk).high);
  EXPECT_EQ(back.bounds(walk).low, bare.bounds(walk).low);
  EXPECT_EQ(back.bounds(), bare.bounds());
}

TEST(Save, KeepsTheWayOfClipsThatWalkInPlace) {
  const Character strider = load(model, {.walk_in_place = true})->characters.front();
  const Character back = saved_and_loaded(strider);
  Crowd crowd = std::move(*Crowd::create(back));
  const Agent agent = crowd.agent(crowd.add_agent());
  agent.play({.clip = back.find_clip("walk")});
  crowd.advance(ticks_per_second);
  EXPECT_GT(agent.motion().displacement(Ticks{}, ticks_per_second).displacement.z, 1.0F);
}

TEST(Save, TakesSeveralCharactersAndClipsThatCameLater) {
  const test::OwnFolder folder;
  const std::string pack = folder.path() / "town.pack";
  const Character less = *mannequin().without(mannequin().find_clip("wave"));
  const Character both[] = {mannequin(), less};
  ASSERT_TRUE(save(pack, both));
  const auto opened = pack::Pack::open(pack);
  ASSERT_TRUE(opened) << opened.error().message;
  const std::string name = mannequin().data()->baked->skeleton.name;
  EXPECT_THAT(opened->names(0), testing::ElementsAre(name, name + " 2"));
  EXPECT_EQ(opened->baked(0, 1)->prepared.placement.height, mannequin().height());
  const auto loaded = load(pack);
  ASSERT_EQ(loaded->characters.size(), 2U);
  EXPECT_TRUE(loaded->characters[0].find_clip("wave").valid());
  EXPECT_FALSE(loaded->characters[1].find_clip("wave").valid());
  EXPECT_EQ(hash_of(loaded->characters[1], loaded->characters[1].find_clip("walk")),
            hash_of(mannequin(), mannequin().find_clip("walk")));
}

TEST(Save, OfNothingIsAMisuseAndToNowhereAnError) {
  const HeardMisuses heard;
  EXPECT_FALSE(save("none.pack", {}));
  const Character empty;
  EXPECT_FALSE(save("none.pack", {&empty, 1}));
  EXPECT_EQ(HeardMisuses::all().size(), 2U);
  EXPECT_FALSE(std::filesystem::exists("none.pack"));
  const Status nowhere = save("/no/such/folder/man.pack", {&mannequin(), 1});
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr("/no/such/folder/man.pack"));
}

TEST(Keys, AreLetGoUnlessTheyArePlayedOrAskedFor) {
  const Character kept = load(model, {.keep_keys = true})->characters.front();
  EXPECT_GT(bytes_of_keys(kept), 4'000'000U);
  EXPECT_EQ(bytes_of_keys(mannequin()), 0U);
  for (const anim::BakedClip& clip : mannequin().data()->baked->clips) EXPECT_NE(clip.sampled(), nullptr) << clip.name;
  EXPECT_EQ(hash_of(kept), hash_of(mannequin()));
  EXPECT_EQ(bytes_of_keys(saved_and_loaded(kept, {.keep_keys = true})), bytes_of_keys(kept));
}

}  // namespace
}  // namespace throng::save_test
