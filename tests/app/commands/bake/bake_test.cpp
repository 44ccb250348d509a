// `throng bake`, and what every command makes of the pack.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/character/built_in.h"
#include "app/character/cast_files.h"
#include "app/character/model_file.h"
#include "app/character/packed.h"
#include "app/commands/bake/command.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/render/mesh/packed_surface.h"
#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::bake_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string features = THRONG_SOURCE_DIR "/tests/data/features/";
const std::string person = features + "linear-trs.glb", other = features + "late-start.glb";

class Bake : public test::TemporaryFolder {
 protected:
  /// Bakes some models into a pack, and returns its path.
  std::string baked(const std::vector<std::string>& models, const std::vector<std::string>& options = {}) {
    const std::string pack = (folder_ / "town.pack").string();
    std::vector<std::string> arguments{"bake"};
    arguments.insert(arguments.end(), models.begin(), models.end());
    arguments.insert(arguments.end(), {"-o", pack});
    arguments.insert(arguments.end(), options.begin(), options.end());
    run_ = run_program(arguments);
    EXPECT_EQ(run_.exit_status, 0) << run_.errors;
    return pack;
  }
  ProgramRun run_;
};

/// Copies the files of the built-in character, and bakes a pack of them beside the copies.
BuiltInFiles baked_built_in(const std::filesystem::path& folder) {
  BuiltInFiles files{folder / "assets/mannequin.glb", folder / "assets/wardrobe.glb"};
  std::filesystem::create_directories(folder / "assets");
  for (const std::filesystem::path& file : {files.mannequin, files.wardrobe}) {
    std::filesystem::copy_file(std::filesystem::path(THRONG_SOURCE_DIR) / "assets" / file.filename(), file);
  }
  const std::string pack = (folder / "assets" / built_in_pack_name).string();
  const ProgramRun run = run_program({"bake", "--built-in", "--data", folder.string(), "-o", pack});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  return files;
}

nlohmann::json posed(const std::string& model, const std::string& stream) {
  const ProgramRun run =
      run_program({"pose", model, "--clip", "0", "--time", "0,0.3,1.7", "--stream", stream, "--json", "-"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  nlohmann::json json = nlohmann::json::parse(run.output, nullptr, false);
  json.erase("file");
  return json;
}

CharacterSource loaded(const std::string& file, const LoadOptions& options = {}) {
  auto character = load_character(file, file, nullptr, options);
  EXPECT_TRUE(character) << (character ? "" : character.error().message);
  return std::move(*character);
}

TEST_F(Bake, WritesBesideAPackThatPlays) {
  const std::string pack = baked({person});
  const auto mapped = pack::Pack::open(pack);
  ASSERT_TRUE(mapped) << mapped.error().message;
  const std::vector<std::byte> before(mapped->surface(0, 0).begin(), mapped->surface(0, 0).end());
  baked({other});
  EXPECT_TRUE(std::ranges::equal(mapped->surface(0, 0), before)) << "the former pack changed";
}

TEST_F(Bake, APackOfAPersonMayBeCutWhileItPlays) {
  const std::string pack = baked({person});
  const CharacterSource source = loaded(pack);
  fs::resize_file(pack, 0);
  const auto system = anim::AnimationSystem::create(source.character, {});
  ASSERT_TRUE(system);
  const AgentId agent = (*system)->add_agent();
  (*system)->agent(agent).play({.clip = 0});
  const PoseRequest update{.agent = agent};
  (*system)->update({&update, 1});
  EXPECT_EQ((*system)->figures().report().agents_updated, 1U);
}

TEST_F(Bake, SaysWhatThePackHolds) {
  baked({person, other});
  EXPECT_THAT(run_.output, StartsWith("linear-trs: 1 character, 1 clip\nlate-start: 1 character, "));
  EXPECT_THAT(run_.output, HasSubstr("town.pack: "));
  EXPECT_THAT(run_.output, HasSubstr(", of which streams "));
}

TEST_F(Bake, KeepsPosesToTheBit) {
  for (const char* const file : {"linear-trs.glb", "cubic-trs.glb", "step-trs.glb", "negative-scale-joint.glb",
                                 "late-start.glb", "two-skins-one-skeleton.glb"}) {
    const std::string pack = baked({features + file}, {"--keep-keys"});
    for (const char* const stream : {"sampled", "keyframe"}) {
      EXPECT_EQ(posed(pack, stream), posed(features + file, stream)) << file << " " << stream;
    }
  }
}

TEST_F(Bake, LeavesTheKeysOutUnlessTheyAreAskedFor) {
  const std::string pack = baked({person}, {"--keep-keys"});
  const auto with_keys = fs::file_size(pack);
  baked({person});
  EXPECT_LT(fs::file_size(pack), with_keys);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"inspect", pack}, {"pose", pack, "--clip", "0", "--time", "0", "--json", "-"}}) {
    const ProgramRun run = run_program(command);
    EXPECT_EQ(run.exit_status, 1) << command.front();
    EXPECT_THAT(run.errors, HasSubstr("town.pack: it has no keys of its model, which this needs: bake it with"));
  }
  EXPECT_THAT(load_character(pack, pack, nullptr, {.placement = {.scale = 0.5}}).error().message,
              HasSubstr("--keep-keys"));
}

TEST_F(Bake, MakesTheCharacterThatTheFileMakes) {
  const CharacterSource from_file = loaded(person), from_pack = loaded(baked({person}));
  EXPECT_EQ(from_pack.clip_names, from_file.clip_names);
  EXPECT_EQ(from_pack.placement.reasons, from_file.placement.reasons);
  EXPECT_EQ(from_pack.character->bounds.height, from_file.character->bounds.height);
  EXPECT_EQ(from_pack.model.meshes[0].positions, from_file.model.meshes[0].positions);
  EXPECT_EQ(from_pack.roles.clips, from_file.roles.clips);
  EXPECT_FALSE(from_pack.surface.bytes.empty());
  const auto drawn = render::surface_parts(mesh_data(from_pack)), built = render::surface_parts(mesh_data(from_file));
  EXPECT_EQ(drawn->pieces[0].triangles_by_level, built->pieces[0].triangles_by_level);
  EXPECT_EQ(drawn->pieces[0].error_by_level, built->pieces[0].error_by_level);
}

TEST_F(Bake, GivesACastWhereThePackHoldsSeveralFiles) {
  const std::string pack = baked({person, other, person});
  const std::vector<std::string> files{pack};
  const auto cast = load_cast(cast_of(files));
  ASSERT_TRUE(cast) << cast.error().message;
  std::vector<std::string> names;
  for (const CharacterSource& character : cast->characters) names.push_back(character.file);
  EXPECT_THAT(names, ElementsAre(pack + "#linear-trs", pack + "#late-start", pack + "#linear-trs 2"));
  EXPECT_EQ(loaded(pack + "#late-start").clip_names, loaded(other).clip_names);
}

TEST_F(Bake, PutsPacksOfAFolderIntoItsCast) {
  baked({person, other});
  const std::vector<std::string> folder{folder_.string()};
  const auto cast = load_cast(cast_of(folder));
  ASSERT_TRUE(cast) << cast.error().message;
  EXPECT_EQ(cast->characters.size(), 2U);
}

TEST_F(Bake, PutsNobodyTwiceIntoTheCastOfAFolder) {
  baked({person});
  fs::copy_file(person, folder_ / "person.glb");
  const std::vector<std::string> folder{folder_.string()};
  const auto cast = load_cast(cast_of(folder));
  ASSERT_TRUE(cast) << cast.error().message;
  EXPECT_EQ(cast->characters.size(), 1U);
}

TEST_F(Bake, AsksWhichFileOfAPackIsMeant) {
  const std::string pack = baked({person, other}, {"--keep-keys"});
  EXPECT_THAT(read_model_file(pack).error().message,
              HasSubstr("town.pack: it holds 2 files; say which behind a #: linear-trs or late-start"));
  EXPECT_TRUE(read_model_file(pack + "#late-start"));
  EXPECT_THAT(read_model_file(pack + "#nobody").error().message,
              HasSubstr("town.pack: it has no character \"nobody\"; it has linear-trs and late-start"));
}

TEST_F(Bake, TakesSizeAndPlaceFromTheCommandLine) {
  const std::string pack = baked({person}, {"--scale", "3"});
  EXPECT_EQ(loaded(pack).placement.placement.scale, 3.0);
  EXPECT_EQ(loaded(pack).character->bounds.height,
            loaded(person, {.placement = {.scale = 3.0}}).character->bounds.height);
}

TEST_F(Bake, IsDoneAnewWhereTheRunAsksForAnotherSize) {
  const std::string pack = baked({person}, {"--scale", "3", "--keep-keys"});
  const CharacterSource smaller = loaded(pack, {.placement = {.scale = 0.5}});
  EXPECT_EQ(smaller.placement.placement.scale, 0.5);
  EXPECT_TRUE(smaller.surface.bytes.empty()) << "it is of the former size";
}

TEST_F(Bake, PacksTheClipsOfOtherFiles) {
  const std::string pack = baked({person}, {"--clips-from", person});
  EXPECT_EQ(loaded(pack).clip_names.size(), 2 * loaded(person).clip_names.size());
}

TEST_F(Bake, PacksTheOrderOfBonesThatAPersonKept) {
  const std::string model = (folder_ / "person.glb").string();
  fs::copy_file(person, model);
  const CharacterSource before = loaded(model);
  BoneLodChoice choice = present_bone_lod(before.model.skeleton.bones.size(), {before.model.skeleton.bone_count(), 1});
  CharacterSource kept = loaded(model);
  take_order(kept, choice);
  ASSERT_TRUE(BoneLodFile(model).write(kept.character->skeleton));
  const CharacterSource packed = loaded(baked({model}));
  EXPECT_THAT(packed.character->skeleton.level_bone_counts, ElementsAre(before.model.skeleton.bone_count(), 1));
  EXPECT_EQ(packed.model.skeleton.level_bone_counts, packed.character->skeleton.level_bone_counts);
}

TEST_F(Bake, DropsThePackedSurfaceWhenBonesGetAnotherOrder) {
  CharacterSource packed = loaded(baked({person}));
  take_order(packed, present_bone_lod(packed.model.skeleton.bones.size(), {packed.model.skeleton.bone_count()}));
  EXPECT_TRUE(packed.surface.bytes.empty());
}

TEST_F(Bake, WritesNothingWhereAModelIsRefused) {
  const std::string pack = (folder_ / "none.pack").string();
  const ProgramRun run = run_program({"bake", person, (folder_ / "absent.glb").string(), "-o", pack});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_THAT(run.errors, HasSubstr("absent.glb"));
  EXPECT_FALSE(fs::exists(pack));
}

TEST_F(Bake, IsRefusedInEveryCommandOnceABitIsFlipped) {
  const std::string pack = baked({person});
  const auto size = static_cast<std::streamoff>(fs::file_size(pack));
  std::fstream stream(pack, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekg(size / 2);
  const char byte = static_cast<char>(stream.get() ^ 1);
  stream.seekp(size / 2);
  stream.put(byte);
  stream.close();
  for (const std::vector<std::string>& command : {std::vector<std::string>{pack, "--headless=none"},
                                                  {"inspect", pack},
                                                  {"bench", pack},
                                                  {"lod", pack},
                                                  {"pose", pack, "--clip", "0", "--time", "0", "--json", "-"}}) {
    const ProgramRun run = run_program(command);
    EXPECT_EQ(run.exit_status, 1) << command.front();
    EXPECT_THAT(run.errors, HasSubstr("town.pack: it is damaged: its checksum does not fit; bake it again"));
    EXPECT_EQ(run.output, "");
  }
}

TEST_F(Bake, MakesThePackThatTheBuiltInCharacterIsTakenFrom) {
  const BuiltInFiles files = baked_built_in(folder_);
  const auto made = make_built_in(files, {.wardrobe = true});
  const auto taken = take_built_in(files, {.wardrobe = true});
  ASSERT_TRUE(made && taken);
  EXPECT_EQ(taken->name, made->name);
  EXPECT_EQ(taken->cast, made->cast);
  EXPECT_EQ(taken->clip_names, made->clip_names);
  EXPECT_EQ(taken->roles.clips, made->roles.clips);
  ASSERT_EQ(taken->model.parts.size(), made->model.parts.size());
  for (std::size_t part = 0; part < made->model.parts.size(); ++part) {
    ASSERT_EQ(taken->model.parts[part].name, made->model.parts[part].name);
    ASSERT_EQ(taken->model.parts[part].meshes.front().positions, made->model.parts[part].meshes.front().positions);
  }
  const auto surface = render::pack_surface(render::view_of(render::build_surface(mesh_data(*made))));
  EXPECT_TRUE(std::ranges::equal(taken->surface.bytes, surface)) << "pictures are the same";
}

TEST_F(Bake, LeavesABuiltInCharacterAloneThatIsAskedForInAnotherWay) {
  const BuiltInFiles files = baked_built_in(folder_);
  EXPECT_TRUE(take_built_in(files, {})->model.parts.empty()) << "nobody dresses";
  EXPECT_FALSE(take_built_in(files, {.placement = {.scale = 2.0}}));
  EXPECT_FALSE(take_built_in(files, {.clips_from = {person}}));
  std::ofstream(files.wardrobe, std::ios::app) << ' ';
  EXPECT_FALSE(take_built_in(files, {})) << "the pack is of another wardrobe";
}

}  // namespace
}  // namespace throng::app::bake_test
