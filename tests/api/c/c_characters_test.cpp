// Characters, their clips and meshes, and how they are loaded, through the functions for C.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"
#include "tests/own_folder.h"

namespace throng::c_characters_test {
namespace {

using api_test::CCrowd;
using api_test::first_character;
using api_test::mannequin;
using testing::HasSubstr;

constexpr const char* model = THRONG_SOURCE_DIR "/assets/mannequin.glb";

TEST(ApiCCharacter, IsDescribedAsInCpp) {
  const CCrowd c(0);
  const std::uint32_t hand = c.bone("hand.R"), walk = c.clip("walk");
  EXPECT_EQ(hand, static_cast<std::uint32_t>(*mannequin().find_bone("hand.R")));
  EXPECT_STREQ(throng_character_bone_name(c.character, throng_character_bone_parent(c.character, hand)), "forearm.R");
  EXPECT_EQ(throng_character_bone_parent(c.character, 0), THRONG_NONE);
  EXPECT_EQ(throng_character_find_bone(c.character, "tail"), THRONG_NONE);
  EXPECT_EQ(throng_character_bone_name(c.character, 5000), nullptr);
  EXPECT_STREQ(throng_character_clip_name(c.character, walk), "walk");
  EXPECT_EQ(throng_character_clip_name(c.character, 5000), nullptr);
  EXPECT_EQ(throng_character_clip_loops(c.character, walk), 1);
  EXPECT_EQ(throng_character_clip_ground_speed(c.character, walk), mannequin().clip({walk}).ground_speed);
  EXPECT_EQ(throng_character_height(c.character), mannequin().height());
  EXPECT_EQ(throng_character_level_count(c.character), static_cast<std::uint32_t>(mannequin().level_count()));
  EXPECT_EQ(throng_character_palette_entries(c.character, 1), mannequin().palette_entries(1));
  EXPECT_EQ(throng_character_missing_rig(c.character, 0), nullptr) << "the mannequin can do all";
}

TEST(ApiCCharacter, IsLoadedWithTheRigThatAHostNames) {
  throng_load_options options = throng_load_options_default();
  const throng_bone_role neck = {"head", "neck"}, tail = {"tail", "head"};
  options.rig = &neck;
  options.rig_count = 1;
  throng_file* const file = throng_load_with(model, &options);
  EXPECT_NE(file, nullptr) << throng_last_error();
  throng_file_free(file);
  options.rig = &tail;
  EXPECT_EQ(throng_load_with(model, &options), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("VRM 1.0 has no part of the body named \"tail\""));
}

TEST(ApiCCharacter, ListsTablesForARendererAndSaysHowLongTheyAre) {
  const CCrowd c(0);
  const std::vector<std::uint16_t> expected = mannequin().entries_at_level(1);
  std::vector<std::uint16_t> entries(expected.size());
  EXPECT_EQ(throng_character_entries_at_level(c.character, 1, nullptr, 0), expected.size());
  throng_character_entries_at_level(c.character, 1, entries.data(), static_cast<std::uint32_t>(entries.size()));
  EXPECT_EQ(entries, expected);
  const auto frames = mannequin().packing_frames();
  std::vector<float> numbers(4 * frames.size());
  EXPECT_EQ(throng_character_packing_frames(c.character, numbers.data(), static_cast<std::uint32_t>(frames.size())),
            frames.size());
  EXPECT_EQ(numbers.back(), frames.back()[3]);
}

TEST(ApiCCharacter, GivesItsSurfaceIfItIsKept) {
  const CCrowd c(0);
  ASSERT_EQ(throng_character_mesh_count(c.character), mannequin().mesh_count());
  throng_mesh mesh = throng_mesh_default();
  ASSERT_EQ(throng_character_mesh(c.character, 0, &mesh), 0);
  const MeshView view = mannequin().mesh(0);
  EXPECT_EQ(mesh.name, view.name);
  ASSERT_EQ(mesh.vertex_count, view.positions.size());
  EXPECT_EQ(mesh.positions[3 * mesh.vertex_count - 1], view.positions.back().z);
  EXPECT_EQ(mesh.indices[mesh.index_count - 1], view.indices.back());
  EXPECT_EQ(mesh.palette_entries[4], view.palette_entries[1][0]);
  EXPECT_EQ(mesh.weights[4], view.weights[1][0]);
  EXPECT_NE(throng_character_mesh(c.character, 99, &mesh), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("keep_meshes"));
}

TEST(ApiCCharacter, ExchangesClipsWhileAgentsPlay) {
  const CCrowd c(1);
  c.play(0, c.clip("walk"));
  c.step();
  const std::uint32_t wave = c.clip("wave");
  throng_character* const played = throng_crowd_character(c.crowd, first_character);
  throng_character* const less = throng_character_without(played, wave);
  ASSERT_NE(less, nullptr) << throng_last_error();
  EXPECT_EQ(throng_character_has_clip(less, wave), 0);
  EXPECT_EQ(throng_crowd_replace_character(c.crowd, first_character, less), 0);
  EXPECT_NE(c.play(0, wave), 0) << "it was unloaded";
  throng_character* alone = throng_character_without(c.character, 0);
  for (std::uint32_t clip = 1; clip < throng_character_clip_count(c.character); ++clip) {
    if (clip == wave) continue;
    throng_character* const fewer = throng_character_without(alone, clip);
    throng_character_free(alone);
    alone = fewer;
  }
  throng_character* const whole = throng_character_with_clips(less, alone);
  ASSERT_NE(whole, nullptr) << throng_last_error();
  EXPECT_EQ(throng_crowd_replace_character(c.crowd, first_character, whole), 0) << throng_last_error();
  EXPECT_EQ(c.play(0, throng_character_find_clip(whole, "wave")), 0);
  EXPECT_EQ(throng_character_with_clips(whole, alone), nullptr) << "the clip is there";
  EXPECT_STRNE(throng_last_error(), "");
  for (throng_character* one : {played, less, alone, whole}) throng_character_free(one);
}

TEST(ApiCFile, IsLoadedWithOptionsAndHasNotes) {
  throng_load_options options = throng_load_options_default();
  options.metres_a_unit = 2.0;
  throng_file* const twice = throng_load_with(model, &options);
  ASSERT_NE(twice, nullptr) << throng_last_error();
  throng_character* const giant = throng_file_character(twice, 0);
  EXPECT_NEAR(throng_character_height(giant), 2.0 * mannequin().height(), 0.01);
  EXPECT_EQ(throng_character_mesh_count(giant), 0U) << "they were not asked for";
  const LoadedFile loaded = *load(model, {.scale = 2.0});
  for (std::uint32_t i = 0; i < loaded.notes.size(); ++i) EXPECT_EQ(throng_file_note(twice, i), loaded.notes[i]);
  EXPECT_GT(loaded.notes.size(), 0U);
  EXPECT_EQ(throng_file_note(twice, static_cast<std::uint32_t>(loaded.notes.size())), nullptr);
  throng_character_free(giant);
  throng_file_free(twice);
}

TEST(ApiCFile, IsLoadedFromMemoryWithTheFilesThatItNames) {
  const api_test::CMisuses misuses;
  std::ifstream stream(model, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const throng_bytes files[] = {{.name = "man.glb", .bytes = bytes.data(), .count = bytes.size()},
                                {.name = "unused.bin", .bytes = bytes.data(), .count = 4}};
  throng_file* const file = throng_load_bytes_with(files, 2, nullptr);
  ASSERT_NE(file, nullptr) << throng_last_error();
  EXPECT_EQ(throng_file_character_count(file), 1U);
  throng_file_free(file);
  EXPECT_EQ(throng_load_bytes_with(files, 0, nullptr), nullptr);
  EXPECT_STRNE(throng_last_error(), "");
}

/// Saves the mannequin through C, loaded with or without its keys.
void save_mannequin(const std::string& pack, bool keeps_keys) {
  throng_load_options options = throng_load_options_default();
  options.keep_keys = keeps_keys ? 1 : 0;
  throng_file* const file = throng_load_with(model, &options);
  throng_character* const character = throng_file_character(file, 0);
  const throng_character* const list[] = {character};
  EXPECT_EQ(throng_save(pack.c_str(), list, 1), 0) << throng_last_error();
  throng_character_free(character);
  throng_file_free(file);
}

TEST(ApiCFile, IsSavedAsAPackThatPlaysToTheBitAndHasTheKeysThatWereKept) {
  const test::OwnFolder folder;
  const std::string rows = folder.path() / "rows.pack", keys = folder.path() / "keys.pack";
  save_mannequin(rows, false);
  save_mannequin(keys, true);
  EXPECT_GT(std::filesystem::file_size(keys), std::filesystem::file_size(rows));
  throng_file* const file = throng_load(rows.c_str(), 0.0);
  ASSERT_NE(file, nullptr) << throng_last_error();
  throng_character* const back = throng_file_character(file, 0);
  const std::uint32_t walk = throng_character_find_clip(back, "walk");
  const Character loaded = load(rows)->characters.front();
  EXPECT_EQ(throng_character_clip_seconds(back, walk), to_seconds(mannequin().clip({walk}).duration));
  EXPECT_EQ(api_test::hash_of(loaded, {walk}), api_test::hash_of(mannequin(), {walk}));
  throng_character_free(back);
  throng_file_free(file);
}

TEST(ApiCFile, OfNothingIsNotSaved) {
  const CCrowd c(1);
  const throng_character* const one[] = {c.character, nullptr};
  EXPECT_NE(throng_save("none.pack", one, 2), 0);
  EXPECT_STREQ(throng_last_error(), "throng_save: a pointer is null");
  EXPECT_NE(throng_save("none.pack", one, 0), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("there is no character"));
  EXPECT_NE(throng_save("/no/such/folder/man.pack", one, 1), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("/no/such/folder/man.pack"));
  EXPECT_EQ(c.heard.size(), 2U) << "a folder that there is not is no misuse";
}

}  // namespace
}  // namespace throng::c_characters_test
