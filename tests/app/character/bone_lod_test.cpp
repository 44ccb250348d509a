// The order of a character's bones as a person may change it: by hand, in a file, while the crowd goes on.
#include "app/character/bone_lod.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "throng/heap_pages.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "engine/anim/import/import.h"

namespace throng::app::bone_lod_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

//   hips - spine - head
//        \ leg - foot
anim::Skeleton small_skeleton() {
  anim::Skeleton skeleton;
  const std::vector<std::pair<std::string, int>> bones{
      {"hips", -1}, {"spine", 0}, {"head", 1}, {"leg", 0}, {"foot", 3}};
  for (const auto& [name, parent] : bones) {
    anim::Bone& bone = skeleton.bones.emplace_back();
    bone.name = name;
    bone.node = 10 + static_cast<int>(skeleton.bones.size());
    bone.parent = parent;
  }
  skeleton.level_bone_counts = {5, 3};
  return skeleton;
}
const std::vector<int> parents{-1, 0, 1, 0, 3};

std::string refusal(std::vector<int> bones, std::vector<int> counts) {
  const Status checked = check_bone_lod(small_skeleton(), {std::move(bones), std::move(counts)});
  return checked ? "(taken)" : checked.error().message;
}

TEST(BoneLodChoice, IsEveryBoneOnceAfterItsParentInLevelsThatShrink) {
  EXPECT_EQ(refusal({0, 3, 4, 1, 2}, {5, 3, 1}), "(taken)");
  EXPECT_EQ(refusal({0, 2, 1, 3, 4}, {5}), "bone \"head\" comes before its parent \"spine\"");
  EXPECT_EQ(refusal({0, 1, 1, 3, 4}, {5}), "bone \"spine\" is listed twice");
  EXPECT_EQ(refusal({0, 1, 2, 3}, {5}), "bone \"foot\" is missing");
  EXPECT_EQ(refusal({0, 1, 2, 3, 7}, {5}), "a bone that the model does not have");
  EXPECT_EQ(refusal({0, 1, 2, 3, 4}, {4}), "level 0 must keep all 5 bones");
  EXPECT_EQ(refusal({0, 1, 2, 3, 4}, {5, 5}), "level 1 must keep at least 1 bone and fewer than level 0");
  EXPECT_EQ(refusal({0, 1, 2, 3, 4}, {5, 4, 0}), "level 2 must keep at least 1 bone and fewer than level 1");
  EXPECT_EQ(refusal({0, 1, 2, 3, 4}, {}), "there must be 1 to 4 levels");
}

TEST(BoneLodChoice, StaysValidWhereverABoneIsMoved) {
  const BoneLodChoice choice = present_bone_lod(small_skeleton().bones.size(), small_skeleton().level_bone_counts);
  EXPECT_THAT(with_bone_moved(parents, choice, 4, 1).bones, ElementsAre(0, 3, 4, 1, 2)) << "the leg comes along";
  EXPECT_THAT(with_bone_moved(parents, choice, 1, 3).bones, ElementsAre(0, 3, 1, 2, 4)) << "the head comes along";
  for (std::size_t from = 0; from < 5; ++from) {
    for (std::size_t to = 0; to < 5; ++to) {
      EXPECT_TRUE(check_bone_lod(small_skeleton(), with_bone_moved(parents, choice, from, to))) << from << " " << to;
    }
  }
}

TEST(BoneKeys, TellBonesOfOneNameApartByTheirNodes) {
  anim::Skeleton skeleton = small_skeleton();
  skeleton.bones[2].name = "spine";
  skeleton.bones[4].name.clear();
  EXPECT_THAT(bone_keys(skeleton), ElementsAre("hips", "spine#12", "spine#13", "leg", "#15"));
}

/// A folder with a model in it.
struct BoneLodFileTest : testing::Test {
  fs::path folder = fs::temp_directory_path() / ("throng_bones_" + std::to_string(getpid()));
  fs::path model = folder / "Fox.glb";
  fs::path beside = folder / "Fox.glb.lod.json";

  BoneLodFileTest() { fs::create_directories(folder); }
  ~BoneLodFileTest() override { fs::remove_all(folder); }
  BoneLodFileTest(const BoneLodFileTest&) = delete;
  BoneLodFileTest& operator=(const BoneLodFileTest&) = delete;

  std::string refusal_of(const std::string& text) const {
    std::ofstream(beside) << text;
    const auto read = BoneLodFile(model).read(small_skeleton());
    return read ? "(taken)" : read.error().message;
  }
};

TEST_F(BoneLodFileTest, GivesBackWhatWasWrittenInTheModelsOwnOrder) {
  anim::Model reordered;
  reordered.skeleton = small_skeleton();
  reordered.skeleton.references.resize(5);
  anim::reorder_bones(reordered, {.bones = {0, 3, 4, 1, 2}, .level_counts = {5, 2}});
  const auto written = BoneLodFile(model).write(reordered.skeleton);
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, beside);
  const auto read = BoneLodFile(model).read(small_skeleton());
  ASSERT_TRUE(read && read->has_value());
  EXPECT_THAT((*read)->bones, ElementsAre(0, 3, 4, 1, 2));
  EXPECT_THAT((*read)->level_counts, ElementsAre(5, 2));
}

TEST_F(BoneLodFileTest, IsNotNeeded) {
  const auto read = BoneLodFile(model).read(small_skeleton());
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->has_value());
}

TEST_F(BoneLodFileTest, IsRefusedInOneLineThatNamesFileObjectAndRemedy) {
  const std::string bones = R"("bones": ["hips", "spine", "head", "leg", "foot"])";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"{", "is not JSON"},
      {"[]", "must be an object"},
      {R"({"version": 2})", "\"version\" must be 1"},
      {R"({"version": 1, "bone": []})", "unknown key \"bone\""},
      {R"({"version": 1})", "\"bones\" is missing"},
      {R"({"version": 1, "bones": [3], "level_counts": [5]})", "must be an array of texts"},
      {R"({"version": 1, "bones": ["tail"], "level_counts": [5]})", "the model has no bone \"tail\""},
      {R"({"version": 1, "bones": ["hips"], "level_counts": [5]})", "bone \"spine\" is missing"},
      {R"({"version": 1, )" + bones + R"(, "level_counts": [5, -1]})", "must be an array of whole numbers"},
      {R"({"version": 1, )" + bones + R"(, "level_counts": [5, 5]})", "level 1 must keep"},
      {R"({"version": 1, )" + bones + "}", "\"level_counts\" is missing"}};
  for (const auto& [text, sentence] : wrong) {
    const std::string message = refusal_of(text);
    EXPECT_THAT(message, HasSubstr(beside.string())) << text;
    EXPECT_THAT(message, HasSubstr(sentence)) << text;
    EXPECT_THAT(message, HasSubstr("delete it")) << text;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_EQ(refusal_of(R"({"version": 1, )" + bones + R"(, "level_counts": [5, 3]})"), "(taken)");
}

/// A small crowd whose bones change places.
class ReorderedStage : public testing::Test {
 protected:
  static constexpr Ticks frame = ticks_per_second / 60;

  std::unique_ptr<Stage> open(const Tuning& tuning) {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin"));
    auto made = Stage::create(std::move(characters), tuning, pages_);
    return made ? std::move(*made) : nullptr;
  }
  void pass(Stage& stage, int frames) const {
    for (int i = 0; i < frames; ++i) {
      stage.move(frame);
      stage.pose(camera_, 1280, 720, frame, stage.posed().frame());
    }
  }
  /// Both arms and all below first, and only two levels.
  static BoneLodChoice arms_first(const anim::Skeleton& skeleton) {
    BoneLodChoice choice = present_bone_lod(skeleton.bones.size(), skeleton.level_bone_counts);
    const auto below_an_arm = [&](int bone) {
      for (; bone >= 0; bone = skeleton.bones[static_cast<std::size_t>(bone)].parent) {
        if (skeleton.bones[static_cast<std::size_t>(bone)].name.find("arm") != std::string::npos) return true;
      }
      return false;
    };
    std::ranges::stable_partition(choice.bones, [&](int bone) { return !below_an_arm(bone); });
    choice.level_counts = {skeleton.bone_count(), 20};
    return choice;
  }

  HeapPageSource pages_{std::size_t{1} << 20U};
  render::Camera camera_ = camera_at({.x = 0, .y = 12, .z = 25, .yaw = 0, .pitch = -25});
};

TEST_F(ReorderedStage, PosesTheSameCrowdAsIfTheBonesHadStayed) {
  for (const anim::StreamKind stream : {anim::StreamKind::sampled, anim::StreamKind::keyframe}) {
    const Tuning tuning{.scene = Scene::plaza,
                        .agents = 40,
                        .lod = {.rule = LodRule::off, .bone_lod = false, .smooth = true},
                        .system = {.pus = 1, .stream = stream}};
    const auto stage = open(tuning), as_it_was = open(tuning);
    ASSERT_TRUE(stage && as_it_was);
    pass(*stage, 20);
    pass(*as_it_was, 40);
    const auto set = stage->set_bone_lod(0, arms_first(stage->characters().front().character->skeleton));
    ASSERT_TRUE(set) << set.error().message;
    pass(*stage, 20);
    EXPECT_EQ(stage->system().figures().pose_hash(), as_it_was->system().figures().pose_hash());
    EXPECT_EQ(stage->crowd().positions().size(), 40U);
  }
}

TEST_F(ReorderedStage, HasTheCharacterThatIsBakedInThatOrder) {
  const std::string file = THRONG_SOURCE_DIR "/assets/mannequin.glb";
  CharacterSource source = *load_character(file, "mannequin");
  const BoneLodChoice choice = arms_first(source.character->skeleton);
  take_order(source, choice);
  const anim::Character& reordered = *source.character;
  anim::Model model = std::move(import::import_file(file)->models.front());
  anim::reorder_bones(model, choice);
  const anim::Character anew = anim::bake_character(model);
  EXPECT_EQ(reordered.bone_lod.level_error_metres, anew.bone_lod.level_error_metres);
  EXPECT_EQ(reordered.surface_points.firsts, anew.surface_points.firsts);
  ASSERT_EQ(reordered.clips.size(), anew.clips.size());
  for (std::size_t clip = 0; clip < anew.clips.size(); ++clip) {
    const anim::BakedClip &a = reordered.clips[clip], &b = anew.clips[clip];
    ASSERT_TRUE(a.sampled() != nullptr && b.sampled() != nullptr);
    ASSERT_EQ(a.sampled()->total_size, b.sampled()->total_size);
    EXPECT_EQ(std::memcmp(a.sampled(), b.sampled(), b.sampled()->total_size), 0) << b.name;
    ASSERT_EQ(a.keyframe()->total_size, b.keyframe()->total_size);
    EXPECT_EQ(std::memcmp(a.keyframe(), b.keyframe(), b.keyframe()->total_size), 0) << b.name;
    EXPECT_EQ(a.data_keys.size(), b.data_keys.size()) << b.name;
    EXPECT_EQ(reordered.skip_errors[clip].blended, anew.skip_errors[clip].blended) << b.name;
  }
}

TEST_F(ReorderedStage, HasTheLevelsThatWereChosen) {
  const auto stage = open(
      {.scene = Scene::grid, .agents = 100, .lod = {.rule = LodRule::distance, .smooth = true}, .system = {.pus = 2}});
  ASSERT_TRUE(stage);
  pass(*stage, 10);
  ASSERT_TRUE(stage->set_bone_lod(0, arms_first(stage->characters().front().character->skeleton)));
  pass(*stage, 20);
  const anim::Skeleton& skeleton = stage->characters().front().character->skeleton;
  EXPECT_THAT(skeleton.level_bone_counts, ElementsAre(skeleton.bone_count(), 20));
  EXPECT_EQ(stage->characters().front().model.skeleton.bones[19].name, skeleton.bones[19].name);
  EXPECT_TRUE(std::ranges::any_of(stage->posed().selection().visible,
                                  [](const anim::VisibleAgent& agent) { return agent.bone_level == 1; }));
  for (const anim::VisibleAgent& agent : stage->posed().selection().visible) EXPECT_LE(agent.bone_level, 1);
}

TEST_F(ReorderedStage, RefusesAnOrderThatCannotBeAndGoesOn) {
  const auto stage = open({.scene = Scene::grid, .agents = 10, .system = {.pus = 1}});
  ASSERT_TRUE(stage);
  const auto before = stage->characters().front().character;
  BoneLodChoice choice = present_bone_lod(before->skeleton.bones.size(), before->skeleton.level_bone_counts);
  std::ranges::reverse(choice.bones);
  EXPECT_FALSE(stage->set_bone_lod(0, choice));
  EXPECT_EQ(stage->characters().front().character, before);
  pass(*stage, 2);
}

TEST_F(ReorderedStage, RefusesAnOrderThatMovesKeptJointsAndGoesOn) {
  const auto stage = open({.scene = Scene::grid, .agents = 10, .system = {.pus = 1}});
  ASSERT_TRUE(stage);
  ASSERT_TRUE(stage->posed().keep_joints(stage->animated().system()));
  const CharacterSource& source = stage->characters().front();
  const auto before = source.character;
  const std::vector<glm::u16vec4> entries = source.model.meshes.front().palette_entries;
  EXPECT_FALSE(stage->set_bone_lod(0, arms_first(before->skeleton)));
  EXPECT_EQ(source.character, before);
  EXPECT_EQ(source.model.skeleton.level_bone_counts, before->skeleton.level_bone_counts);
  EXPECT_EQ(source.model.meshes.front().palette_entries, entries);
  pass(*stage, 2);
}

}  // namespace
}  // namespace throng::app::bone_lod_test
