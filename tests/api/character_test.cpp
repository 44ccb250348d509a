// Loading a character and asking what it has.

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/kernel/palette/packed_palette.h"
#include "engine/anim/pack/pack.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/anim/bake/walker_in_place.h"
#include "tests/api/api_crowd.h"
#include "tests/own_folder.h"

namespace throng::character_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;
using testing::HasSubstr;

TEST(ApiCharacter, KnowsItsClipsByName) {
  const ClipId walk = mannequin().find_clip("walk");
  ASSERT_TRUE(walk.valid());
  EXPECT_EQ(mannequin().clip(walk).name, "walk");
  EXPECT_TRUE(mannequin().clip(walk).loops);
  EXPECT_NEAR(mannequin().clip(walk).ground_speed, 1.4, 0.3);
  EXPECT_FALSE(mannequin().find_clip("no such clip").valid());
  EXPECT_EQ(mannequin().clip({}).name, "");
}

/// Returns the built-in character as an artist may write it: its clips idle and walk are named Idle and WALK.
Character with_capitals() {
  const test::OwnFolder folder;
  std::ifstream file(THRONG_SOURCE_DIR "/assets/mannequin.glb", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [from, to] : {std::pair{"\"idle\"", "\"Idle\""}, {"\"walk\"", "\"WALK\""}}) {
    bytes.replace(bytes.find(from), 6, to);
  }
  const std::string copy = folder.path() / "capitals.glb";
  std::ofstream(copy, std::ios::binary) << bytes;
  return load(copy)->characters.front();
}

TEST(ApiCharacter, FindsClipsByTheRolesThatTheirNamesTell) {
  EXPECT_EQ(mannequin().find_role("stand"), mannequin().find_clip("idle"));
  EXPECT_EQ(mannequin().find_role("run"), mannequin().find_clip("run"));
  const Character capitals = with_capitals();
  EXPECT_FALSE(capitals.find_clip("idle").valid());
  EXPECT_EQ(capitals.find_role("stand"), capitals.find_clip("Idle"));
  EXPECT_EQ(capitals.find_role("walk"), capitals.find_clip("WALK"));
}

TEST(ApiCharacter, FindsNoClipThatLeftForARole) {
  const Character less = *mannequin().without(mannequin().find_clip("wave"));
  EXPECT_TRUE(mannequin().find_role("wave").valid());
  EXPECT_FALSE(less.find_role("wave").valid());
  EXPECT_FALSE(Character().find_role("walk").valid());
}

TEST(ApiCharacter, ARoleThatThereIsNotIsAMisuse) {
  const HeardMisuses heard;
  EXPECT_FALSE(mannequin().find_role("Walk").valid());
  ASSERT_EQ(HeardMisuses::all().size(), 1U);
  EXPECT_THAT(HeardMisuses::all().front(), HasSubstr("Character::find_role"));
}

TEST(ApiCharacter, GivesTheFramesThatUnpackItsPackedPalettes) {
  const auto frames = mannequin().packing_frames();
  ASSERT_EQ(frames.size(), mannequin().palette_entries());
  EXPECT_TRUE(Character().packing_frames().empty());
  ApiCrowd matrices(1), packed(1, {.palettes = PaletteFormat::packed});
  for (ApiCrowd* crowd : {&matrices, &packed}) {
    crowd->agent(0).play({.clip = mannequin().find_clip("walk")});
    crowd->step(20);
  }
  for (std::size_t entry = 0; entry < frames.size(); ++entry) {
    anim::PackedPaletteEntry words;
    std::memcpy(&words, packed.palette({0}) + 4 * entry, sizeof(words));
    const auto& frame = frames[entry];
    const anim::PaletteMatrix unpacked = anim::unpack(words, {{frame[0], frame[1], frame[2]}, frame[3]});
    const auto* const floats = reinterpret_cast<const float*>(&unpacked);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(floats[i], matrices.palette({0})[12 * entry + i], 2e-4F) << entry;
  }
}

TEST(ApiCharacter, KnowsItsBones) {
  const auto hand = mannequin().find_bone("hand.R");
  ASSERT_TRUE(hand.has_value());
  EXPECT_EQ(mannequin().bone_name(*hand), "hand.R");
  EXPECT_LT(mannequin().bone_parent(*hand), *hand);
  EXPECT_EQ(mannequin().bone_parent(-7), -1);
  EXPECT_EQ(mannequin().bone_name(1 << 20), "");
  EXPECT_GT(mannequin().palette_entries(0), mannequin().palette_entries(mannequin().level_count() - 1));
}

TEST(ApiCharacter, HasItsSurfaceIfThatIsAskedFor) {
  ASSERT_GT(mannequin().mesh_count(), 0U);
  const MeshView mesh = mannequin().mesh(0);
  ASSERT_FALSE(mesh.positions.empty());
  EXPECT_EQ(mesh.weights.size(), mesh.positions.size());
  EXPECT_EQ(mesh.palette_entries.size(), mesh.positions.size());
  for (const auto& weights : mesh.weights) EXPECT_NEAR(weights[0] + weights[1] + weights[2] + weights[3], 1.0F, 1e-4F);
  EXPECT_EQ(load(THRONG_SOURCE_DIR "/assets/mannequin.glb")->characters.front().mesh_count(), 0U);
}

TEST(ApiCharacter, AnEmptyOneHasNothing) {
  const Character empty;
  EXPECT_FALSE(empty);
  EXPECT_EQ(empty.clip_count(), 0U);
  EXPECT_EQ(empty.bone_count(), 0);
  EXPECT_EQ(empty.palette_entries(), 0U);
  EXPECT_EQ(empty.mesh_count(), 0U);
  EXPECT_TRUE(empty.missing_rigs().empty());
}

TEST(ApiCharacter, SaysWhyAFileIsNone) {
  EXPECT_THAT(load("no-such-model.glb").error().message, HasSubstr("no-such-model.glb"));
  EXPECT_THAT(load("x.glb", {.scale = -1.0}).error().message, HasSubstr("LoadOptions::scale"));
}

TEST(ApiCharacter, OfNoFileEndsTheProgramWithItsSentence) {
  EXPECT_DEATH(static_cast<void>(*load("no-such-model.glb")), "was asked for: no-such-model.glb: ");
  EXPECT_DEATH(static_cast<void>(load("no-such-model.glb")->characters), "was asked for: no-such-model.glb: ");
}

TEST(ApiCharacter, OfAFileThatTakesMoreMemoryThanItMayIsNone) {
  const auto file = load(THRONG_SOURCE_DIR "/assets/mannequin.glb", {.memory_limit = 1'000'000});
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, HasSubstr("mannequin.glb: the file needs "));
}

/// Writes a pack of a model, and returns its path.
std::string pack_of(const anim::Model& model) {
  pack::FileToPack file{.name = "small", .file = {}, .characters = {}};
  file.file.models = {model};
  auto baked = std::make_shared<const anim::Character>(anim::bake_character(file.file.models.front()));
  file.characters.push_back({.name = "small", .prepared = {}, .character = std::move(baked), .surface = {}});
  const std::vector<std::byte> bytes = pack::write_pack({&file, 1});
  const std::string path = testing::TempDir() + "throng_api_small.pack";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path;
}

TEST(ApiCharacter, OfAPackThatWasCopiedPlaysOnWhenTheFileIsCut) {
  const std::string path = pack_of(anim::synthetic_model(5, 1));
  const auto file = load(path, {.copy_pack = true});
  ASSERT_TRUE(file) << file.error().message;
  std::filesystem::resize_file(path, 0);  // a mapping of it would end the program
  auto crowd = Crowd::create(file->characters.front());
  ASSERT_TRUE(crowd);
  const PoseRequest request{.agent = crowd->add_agent()};
  crowd->agent(request.agent).play({.clip = {0}});
  crowd->update({&request, 1});
  EXPECT_EQ(crowd->debug().posed_agents(), 1U);
}

/// Returns how far an agent goes ahead in a second of the first clip.
float way_in_a_second(const Character& character) {
  Crowd crowd = std::move(*Crowd::create(character));
  const Agent agent = crowd.agent(crowd.add_agent());
  agent.play({.clip = {0}});
  crowd.advance(ticks_per_second);
  return agent.motion().displacement(Ticks{}, ticks_per_second).displacement.z;
}

TEST(ApiCharacter, WalksInPlaceWithANoteOrMovesItsAgentsIfThatIsAskedFor) {
  const std::string path = pack_of(anim::walker_in_place(1.4F));
  const auto in_place = load(path);
  ASSERT_TRUE(in_place) << in_place.error().message;
  EXPECT_EQ(way_in_a_second(in_place->characters.front()), 0.0F);
  EXPECT_NEAR(in_place->characters.front().clip({0}).ground_speed, 1.4, 0.02);
  EXPECT_THAT(in_place->notes, testing::ElementsAre(HasSubstr("LoadOptions::walk_in_place lets them: clip (1.4")));
  const auto travels = load(path, {.walk_in_place = true});
  ASSERT_TRUE(travels) << travels.error().message;
  EXPECT_NEAR(way_in_a_second(travels->characters.front()), 1.4F, 0.02F);
  EXPECT_THAT(travels->notes, testing::IsEmpty());
}

}  // namespace
}  // namespace throng::character_test
