#include "engine/anim/pack/pack.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/placement.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/clip_set.h"

namespace throng::pack::pack_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A file with two models; the first is baked with another size, and the second as it is.
FileToPack two_models() {
  FileToPack packed;
  packed.name = "crowd";
  packed.with_keys = true;
  packed.file.file = "crowd.glb";
  packed.file.animations = {"clip_0", "clip_1", "clip_2"};
  packed.file.repairs = {"a weight was repaired"};
  packed.file.models = {anim::synthetic_model(23, 3, 1, 120), anim::synthetic_model(5, 1, 2)};
  anim::Image& image = packed.file.models[0].images.emplace_back();
  static const std::vector<std::uint8_t> texels{1, 2, 3, 4, 5, 6, 7, 8};
  image = {.width = 2, .height = 1, .rgba = texels};
  for (std::size_t i = 0; i < 2; ++i) {
    anim::Model placed = packed.file.models[i];
    CharacterToPack& character = packed.characters.emplace_back();
    character.name = i == 0 ? "large" : "small";
    character.prepared.placement.placement.scale = i == 0 ? 2.0 : 1.0;
    anim::place_model(placed, character.prepared.placement.placement);
    character.character = std::make_shared<const anim::Character>(anim::bake_character(placed));
    character.surface = {std::byte{7}, std::byte{8}, std::byte(i)};
  }
  return packed;
}

const std::vector<std::byte>& packed_bytes() {
  static const std::vector<std::byte> bytes = [] {
    const FileToPack file = two_models();
    return write_pack({&file, 1});
  }();
  return bytes;
}

std::string written(const std::vector<std::byte>& bytes) {
  const std::string path = testing::TempDir() + "throng_pack_test_" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".pack";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path;
}

Pack opened() {
  Result<Pack> pack = Pack::open(written(packed_bytes()));
  EXPECT_TRUE(pack) << (pack ? "" : pack.error().message);
  return std::move(*pack);
}

std::string refusal_of(const std::vector<std::byte>& bytes) {
  const Result<Pack> pack = Pack::open(written(bytes));
  return pack ? "(opened)" : pack.error().message;
}

std::uint64_t pose_hash(std::shared_ptr<const anim::Character> character, anim::StreamKind stream) {
  auto created = anim::AnimationSystem::create(std::move(character), {.pus = 1, .stream = stream, .hash = true});
  anim::AnimationSystem& system = **created;
  system.set_agent_count(3);
  for (std::uint32_t agent = 0; agent < 3; ++agent) system.agent(agent).play({.clip = static_cast<int>(agent)});
  const std::size_t stride = anim::palette_stride(23, PaletteFormat::matrices);
  const anim::AlignedBytes palettes = anim::allocate_aligned(3 * stride);
  std::vector<PoseRequest> updates(3);
  for (std::uint32_t agent = 0; agent < 3; ++agent) {
    updates[agent] = {.agent = {agent}, .palette = palettes.get() + agent * stride};
  }
  for (int frame = 0; frame < 20; ++frame) {
    system.advance(ticks_per_second / 60);
    system.update(updates);
  }
  return system.figures().pose_hash();
}

TEST(Pack, PosesTheBitsOfTheCharacterThatWasBaked) {
  const FileToPack file = two_models();
  auto character = opened().character();
  ASSERT_TRUE(character);
  const auto packed = std::make_shared<const anim::Character>(std::move(*character));
  for (const anim::StreamKind stream : {anim::StreamKind::sampled, anim::StreamKind::keyframe}) {
    EXPECT_EQ(pose_hash(packed, stream), pose_hash(file.characters[0].character, stream));
  }
}

TEST(Pack, ThatWasCopiedPlaysOnWhenItsFileIsCut) {
  const FileToPack file = two_models();
  const std::string path = written(packed_bytes());
  const auto pack = Pack::open(path, PackBytes::copied);
  ASSERT_TRUE(pack) << pack.error().message;
  auto character = pack->character();
  ASSERT_TRUE(character);
  std::filesystem::resize_file(path, 0);  // a mapping of it would end the program
  const auto packed = std::make_shared<const anim::Character>(std::move(*character));
  EXPECT_EQ(pose_hash(packed, anim::StreamKind::sampled),
            pose_hash(file.characters[0].character, anim::StreamKind::sampled));
  EXPECT_THAT(Pack::open(path, PackBytes::copied).error().message, HasSubstr("it is no pack"));
}

TEST(Pack, KeepsWhatWasMeasured) {
  const FileToPack file = two_models();
  const anim::Character& baked = *file.characters[0].character;
  const auto taken = opened().baked(0, 0);
  ASSERT_TRUE(taken);
  const anim::Character& packed = taken->character;
  EXPECT_EQ(taken->prepared.placement.placement.scale, 2.0);
  EXPECT_EQ(packed.bounds.reach, baked.bounds.reach);
  EXPECT_EQ(packed.bone_lod.rows.size(), baked.bone_lod.rows.size());
  EXPECT_EQ(packed.bone_lod.rows.back().error_metres, baked.bone_lod.rows.back().error_metres);
  EXPECT_EQ(packed.skip_errors.back().blended, baked.skip_errors.back().blended);
  EXPECT_EQ(packed.surface_points.firsts, baked.surface_points.firsts);
  EXPECT_EQ(packed.level_entries, baked.level_entries);
  EXPECT_EQ(packed.clips[2].name, "clip_2");
  EXPECT_EQ(packed.clips[2].sampled_error, baked.clips[2].sampled_error);
  EXPECT_EQ(packed.skeleton.bones[7].name, baked.skeleton.bones[7].name);
}

TEST(Pack, KeepsMorphsAndWhatClipsMakeOfThem) {
  FileToPack file = two_models();
  anim::Model& model = file.file.models[0];
  model.morphs.push_back({.name = "smile", .node = 3, .target = 1, .rest_weight = 0.25});
  model.meshes.emplace_back().morph_deltas.push_back({.vertex = 7, .morph = 0, .position = glm::vec3(0.5F)});
  auto morphing = std::make_shared<anim::Character>(anim::bake_character(file.file.models[1]));
  morphing->clips[0].morphs.push_back({.morphs = {0}, .times = {Ticks{0}, Ticks{10}}, .weights = {0.0F, 1.0F}});
  morphing->morph_bones = {2};
  morphing->clips[0].curves.push_back({.name = 0, .times = {Ticks{5}}, .values = {2.5F}});
  morphing->curve_names = {"glow"};
  file.characters[0].character = morphing;
  const auto pack = Pack::open(written(write_pack({&file, 1})));
  ASSERT_TRUE(pack) << pack.error().message;
  const auto character = pack->character();
  ASSERT_EQ(character->clips[0].morphs.size(), 1U);
  EXPECT_THAT(character->clips[0].morphs[0].weights, ElementsAre(0.0F, 1.0F));
  EXPECT_THAT(character->morph_bones, ElementsAre(2));
  ASSERT_EQ(character->clips[0].curves.size(), 1U);
  EXPECT_THAT(character->clips[0].curves[0].values, ElementsAre(2.5F));
  EXPECT_THAT(character->curve_names, ElementsAre("glow"));
  const auto imported = pack->imported(0);
  EXPECT_EQ(imported->models[0].morphs[0].name, "smile");
  EXPECT_EQ(imported->models[0].meshes[0].morph_deltas[0].vertex, 7U);
}

TEST(Pack, UsesStreamsAndTexelsWhereTheyLie) {
  const Pack pack = opened();
  const auto taken = pack.baked(0, 0);
  const auto model = pack.model(0, 0, *taken);
  ASSERT_TRUE(model);
  const auto lies_in_it = [&](const void* bytes) {
    const auto* first = static_cast<const std::byte*>(pack.lender().get());
    const auto* at = static_cast<const std::byte*>(bytes);
    return at >= first && at < first + packed_bytes().size();
  };
  EXPECT_TRUE(lies_in_it(taken->character.clips[0].keyframe_block.get()));
  EXPECT_TRUE(lies_in_it(taken->character.clips[0].sampled_block.get()));
  EXPECT_TRUE(lies_in_it(model->images[0].rgba.data()));
  EXPECT_TRUE(lies_in_it(pack.surface(0, 0).data()));
}

TEST(Pack, StaysAsLongAsACharacterOfItLives) {
  auto character = opened().character();  // the pack itself is gone
  ASSERT_TRUE(character);
  EXPECT_EQ(character->clips[0].keyframe()->bone_count, 23);
}

TEST(Pack, StaysAsLongAsAClipOfItIsLentToAnotherCharacter) {
  auto packed = std::make_shared<const anim::Character>(std::move(*opened().character()));
  const auto lent = anim::without_clip(std::move(packed), 1);
  ASSERT_TRUE(lent);
  EXPECT_TRUE(lent->clips[1].is_empty());
  EXPECT_EQ(lent->clips[0].keyframe()->bone_count, 23);
}

TEST(Pack, GivesAnEmptyClipsStreamBackAsNone) {
  FileToPack file = two_models();
  auto without = std::make_shared<anim::Character>(anim::bake_character(file.file.models[0]));
  without->clips[1].sampled_block = {};
  without->clips[1].note = "plays from its keyframe stream";
  file.characters[0].character = without;
  const auto pack = Pack::open(written(write_pack({&file, 1})));
  ASSERT_TRUE(pack);
  const auto character = pack->character();
  EXPECT_EQ(character->clips[1].sampled(), nullptr);
  EXPECT_NE(character->clips[2].sampled(), nullptr);
  EXPECT_EQ(character->clips[1].note, "plays from its keyframe stream");
}

TEST(Pack, WithoutKeysPlaysAndSaysWhatItLacks) {
  FileToPack file = two_models();
  auto lean = std::make_shared<anim::Character>(anim::bake_character(file.file.models[0]));
  anim::keep_played_streams(*lean);
  file.characters[0].character = lean;
  file.with_keys = false;
  const std::vector<std::byte> bytes = write_pack({&file, 1});
  EXPECT_LT(bytes.size(), packed_bytes().size());
  const auto pack = Pack::open(written(bytes));
  ASSERT_TRUE(pack);
  auto character = pack->character();
  ASSERT_TRUE(character);
  EXPECT_EQ(anim::fault_of(*character), nullptr);
  EXPECT_EQ(character->clips[0].keyframe(), nullptr);
  const auto played = std::make_shared<const anim::Character>(std::move(*character));
  EXPECT_EQ(pose_hash(played, anim::StreamKind::keyframe), pose_hash(played, anim::StreamKind::sampled));
  const auto imported = pack->imported(0);
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().message, HasSubstr("it has no keys of its model"));
  EXPECT_THAT(imported.error().message, HasSubstr("--keep-keys"));
}

TEST(Pack, KeepsTheFileWholeAsImportMadeIt) {
  const FileToPack file = two_models();
  const auto imported = opened().imported(0);
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->animations, file.file.animations);
  EXPECT_EQ(imported->repairs, file.file.repairs);
  ASSERT_EQ(imported->models.size(), 2U);
  const anim::Model& model = imported->models[0];
  const anim::Model& original = file.file.models[0];
  EXPECT_EQ(model.skeleton.references[3].origin, original.skeleton.references[3].origin) << "not the size of the baked";
  ASSERT_EQ(model.clips.size(), 3U);
  EXPECT_EQ(model.clips[1].tracks[4].rotation.values, original.clips[1].tracks[4].rotation.values);
  EXPECT_EQ(model.clips[1].tracks[4].rotation.times, original.clips[1].tracks[4].rotation.times);
  EXPECT_THAT(model.images[0].rgba, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(Pack, GivesTheModelOfACharacterItsSizeAndTheSurveyedKeysAlone) {
  const FileToPack file = two_models();
  ASSERT_GT(file.file.models[0].clips[1].tracks[4].rotation.times.size(), 100U);
  const Pack pack = opened();
  const auto taken = pack.baked(0, 0);
  const auto model = pack.model(0, 0, *taken);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->skeleton.references[3].origin, file.characters[0].character->skeleton.references[3].origin);
  EXPECT_LE(model->clips[1].tracks[4].rotation.times.size(), 32U) << "two around each of sixteen times";
}

TEST(Pack, NamesItsFilesAndCharacters) {
  std::vector<FileToPack> files{two_models(), two_models()};
  files[1].name = "others";
  const auto pack = Pack::open(written(write_pack(files)));
  ASSERT_TRUE(pack);
  EXPECT_EQ(pack->file_count(), 2U);
  EXPECT_EQ(pack->file_name(1), "others");
  EXPECT_THAT(pack->names(1), ElementsAre("large", "small"));
  EXPECT_EQ(pack->surface(1, 1).back(), std::byte{1});
  EXPECT_EQ(pack->character(1, 1)->skeleton.bone_count(), 5);
}

TEST(Pack, IsTheSameBytesForTheSameInput) {
  const FileToPack file = two_models();
  EXPECT_EQ(write_pack({&file, 1}), packed_bytes());
}

TEST(Pack, IsKnownByItsFirstBytesOrItsName) {
  const std::string damaged = written({std::byte{'g'}, std::byte{'l'}});
  EXPECT_TRUE(is_pack(damaged)) << "so that it is refused as a pack";
  const std::string renamed = testing::TempDir() + "throng_pack_test.bin";
  std::filesystem::rename(damaged, renamed);
  EXPECT_FALSE(is_pack(renamed));
  std::filesystem::rename(written(packed_bytes()), renamed);
  EXPECT_TRUE(is_pack(renamed));
  EXPECT_FALSE(is_pack(testing::TempDir() + "absent.pack"));
}

TEST(Pack, IsRefusedInWordsWhereItIsNone) {
  EXPECT_THAT(refusal_of({}), HasSubstr(".pack: it is no pack, or its first bytes are damaged; bake it again"));
  const auto absent = Pack::open(testing::TempDir() + "absent.pack");
  EXPECT_THAT(absent.error().message, HasSubstr("absent.pack: there is no such file"));
  EXPECT_THAT(Pack::open(testing::TempDir()).error().message, HasSubstr("it is a folder, not a file; name a .pack"));
}

}  // namespace
}  // namespace throng::pack::pack_test
