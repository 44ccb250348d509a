#include "app/show/request/crowd_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/settings/tuning_values.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/commands/command_line/command_words.h"
#include "tests/app/program_run.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::crowd_file_test {
namespace {

namespace fs = std::filesystem;
using CrowdFile = test::TemporaryFolder;
using testing::HasSubstr;

void copy_mannequin(const fs::path& file) { fs::copy_file(THRONG_SOURCE_DIR "/assets/mannequin.glb", file); }

std::uint64_t hash_after(Show& show, int frames) {
  for (int frame = 0; frame < frames; ++frame) show.animate(to_ticks(1.0 / 60.0));
  return show.stage().system().figures().pose_hash();
}

// Another order with the same bones: the last two leaves change places.
void change_everything(Show& show) {
  const CharacterSource& person = show.stage().characters()[0];
  RoleClips clips = person.roles.clips;
  clips[index_of(Role::walk)] = clips[index_of(Role::run)];
  EXPECT_TRUE(show.take(SetRoles{0, clips}));
  EXPECT_TRUE(show.take(SetShare{0, 3.0}));
  const anim::Skeleton& skeleton = person.character->skeleton;
  BoneLodChoice choice = present_bone_lod(skeleton.bones.size(), skeleton.level_bone_counts);
  choice.level_counts.back() -= 1;
  ASSERT_TRUE(show.take(SetBones{0, choice}));
  Tuning tuning = show.stage().tuning();
  tuning.seed = 77;
  tuning.error_px = 0.25F;
  ASSERT_TRUE(show.take(Apply{tuning}));
}

TEST_F(CrowdFile, BringsBackTheCrowdThatWasSaved) {
  fs::create_directory(folder_ / "models");
  copy_mannequin(folder_ / "models" / "person.glb");
  const std::string saved = (folder_ / "mine.throng").string();
  std::uint64_t hash = 0;
  {
    const auto show = test::show_of(test::demo("--agents 40 " + (folder_ / "models" / "person.glb").string()));
    change_everything(*show);
    const CameraPose camera{.x = 1, .y = 2, .z = 3, .yaw = 4, .pitch = 5, .field_of_view = 60};
    ASSERT_TRUE(write_crowd_file(saved, crowd_setup(show->stage().people(), {show->stage().tuning(), camera})));
  }
  const auto again = [&](const std::string& file) { return test::show_of(test::demo(file)); };
  const auto show = again(saved);
  EXPECT_EQ(show->stage().tuning().agents, 40);
  EXPECT_EQ(show->stage().tuning().seed, 77U);
  EXPECT_EQ(show->stage().tuning().error_px, 0.25F);
  EXPECT_EQ(show->stage().people()[0].roles.share, 3.0);
  const RoleClips& clips = show->stage().people()[0].roles.clips;
  EXPECT_EQ(clips[index_of(Role::walk)], clips[index_of(Role::run)]);
  EXPECT_EQ(show->view().camera.position, glm::vec3(1, 2, 3));
  hash = hash_after(*show, 20);
  EXPECT_EQ(hash_after(*again(saved), 20), hash) << "the same crowd each time";
  EXPECT_EQ(crowd_setup(show->stage().people(), {show->stage().tuning(), {}}).characters,
            read_crowd_file(saved)->characters);
}

TEST_F(CrowdFile, MovesWithItsModels) {
  fs::create_directories(folder_ / "here" / "models");
  copy_mannequin(folder_ / "here" / "models" / "person.glb");
  const auto show = test::show_of(test::demo("--agents 3 " + (folder_ / "here/models/person.glb").string()));
  ASSERT_TRUE(write_crowd_file(folder_ / "here" / "mine.throng", crowd_setup(show->stage().people(), {})));
  fs::rename(folder_ / "here", folder_ / "there");
  const auto moved = read_crowd_file(folder_ / "there" / "mine.throng");
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->characters[0].file, (folder_ / "there/models/person.glb").string());
  EXPECT_NE(test::show_of(test::demo((folder_ / "there/mine.throng").string())), nullptr);
}

TEST_F(CrowdFile, HoldsTheBuiltInCharacterWithoutAModel) {
  const auto show = test::show_of(test::demo("--agents 3"));
  ASSERT_TRUE(write_crowd_file(folder_ / "mine.throng", crowd_setup(show->stage().people(), {})));
  const auto read = read_crowd_file(folder_ / "mine.throng");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->characters[0].file, "");
  EXPECT_NE(test::show_of(test::demo((folder_ / "mine.throng").string())), nullptr);
}

// Some text of these is another value than the one that it has.
bool takes_another(const TuningValue& value, Tuning& tuning) {
  std::vector<std::string> texts{"on", "off", "0", "1", "2", "0.5", "16", "50"};
  texts.insert(texts.end(), value.words.begin(), value.words.end());
  const std::string before = value.text(tuning);
  return std::ranges::any_of(
      texts, [&](const std::string& text) { return !value.read(tuning, text) && value.text(tuning) != before; });
}

TEST_F(CrowdFile, HoldsEveryValue) {
  for (const TuningValue& value : tuning_values()) {
    CrowdSetup setup{.characters = {{}}, .preset = {}};
    ASSERT_TRUE(takes_another(value, setup.preset.tuning)) << value.key;
    ASSERT_TRUE(write_crowd_file(folder_ / "mine.throng", setup));
    const auto read = read_crowd_file(folder_ / "mine.throng");
    ASSERT_TRUE(read) << value.key;
    EXPECT_EQ(read->preset.tuning, setup.preset.tuning) << value.key;
  }
}

TEST_F(CrowdFile, HoldsWhatIsComparedAndThePlacesOfTheCamera) {
  CrowdSetup setup{.characters = {{}}, .preset = {}};
  Tuning other;
  other.agents = 12;
  setup.pair.take_other(other, "far");
  setup.pair.names[0] = "near";
  setup.bookmarks[0] = CameraPose{.x = 1, .y = 2.5F, .z = -3, .yaw = 4, .pitch = 5, .field_of_view = 60};
  setup.bookmarks[8] = CameraPose{.x = 0.1F};
  ASSERT_TRUE(write_crowd_file(folder_ / "mine.throng", setup));
  const auto read = read_crowd_file(folder_ / "mine.throng");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->pair, setup.pair);
  EXPECT_EQ(read->bookmarks, setup.bookmarks);
}

TEST_F(CrowdFile, OptionsBesideItWinOverItsValues) {
  CrowdSetup setup{.characters = {{}}, .preset = {}};
  setup.preset.tuning.agents = 9;
  ASSERT_TRUE(write_crowd_file(folder_ / "mine.throng", setup));
  const std::string file = (folder_ / "mine.throng").string();
  EXPECT_EQ(test::demo(file).tuning.agents, 9);
  EXPECT_EQ(test::demo("--agents 5 " + file).tuning.agents, 5);
}

TEST_F(CrowdFile, RefusesWhatItDoesNotUnderstandInOneLine) {
  struct Case {
    const char* text;
    const char* said;
  };
  constexpr Case cases[] = {
      {"[]", "object"},
      {R"({"version": 2, "characters": [{}]})", "version"},
      {R"({"version": 1})", "characters"},
      {R"({"version": 1, "characters": []})", "1 to"},
      {R"({"version": 1, "characters": [{}, {}]})", "built-in character stands alone"},
      {R"({"version": 1, "characters": [{"share": -1}]})", "share"},
      {R"({"version": 1, "characters": [{"clips": {"fly": "x"}}]})", "no role \"fly\""},
      {R"({"version": 1, "characters": [{"rig": {"tail": "x"}}]})", "no part \"tail\""},
      {R"({"version": 1, "characters": [{"placement": {"up": "w"}}]})", "-z"},
      {R"({"version": 1, "characters": [{}], "values": {"agents": "many"}})", "agents"},
      {R"({"version": 1, "characters": [{"colour": 1}]})", "colour"},
      {R"({"version": 1, "characters": [{}], "compare": {"in_use": "B"}})", "\"other\" is missing"},
      {R"({"version": 1, "characters": [{}], "bookmarks": []})", "bookmarks must be an object"},
      {R"({"version": 1, "characters": [{}], "bookmarks": {"0": "1,2,3,4,5"}})", "it knows 1, 2"},
      {R"({"version": 1, "characters": [{}], "bookmarks": {"2": "home"}})", "bookmarks: \"2\" must be x,y,z"},
      {R"({"version": 1, "characters": [{}], "bookmarks": {"2": "1,2,3,4,500"}})", "pitch -90 to 90"},
      {R"({"version": 1, "characters": [{}], "bookmarks": {"2": [1]}})", "\"2\" must be"},
      {R"({"version": 1, "characters": [{}], "trajectories": {"fps": 25}})", "\"trajectories\": \"file\" is missing"},
      {R"({"version": 1, "characters": [{}], "trajectories": {"file": "a", "part": 3}})",
       "\"part\" must be two numbers"},
      {R"({"version": 1, "characters": [{}], "camera_path": "zoom"})", "\"camera_path\" must be none, orbit, pan"},
      {R"({"version": 1, "characters": [{}], "camera_name": ""})", "\"camera_name\" must not be empty"},
  };
  const std::string file = (folder_ / "bad.throng").string();
  for (const Case& bad : cases) {
    std::ofstream(file) << bad.text;
    const auto read = read_crowd_file(file);
    ASSERT_FALSE(read) << bad.text;
    EXPECT_THAT(read.error().message, testing::StartsWith(file + ": ")) << bad.text;
    EXPECT_THAT(read.error().message, HasSubstr(bad.said)) << bad.text;
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
  }
}

TEST_F(CrowdFile, SaysWhichClipOrBoneAModelHasNot) {
  CrowdSetup setup{.characters = {{}}, .preset = {}};
  setup.characters[0].clips = {{Role::walk, "Wakling"}};
  ASSERT_TRUE(write_crowd_file(folder_ / "mine.throng", setup));
  const auto run = run_program({"--headless=none", (folder_ / "mine.throng").string()});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_THAT(run.errors, HasSubstr("mine.throng"));
  EXPECT_THAT(run.errors, HasSubstr("walk=Wakling"));
}

TEST_F(CrowdFile, MovesWithItsRecordedCrowdItsWallsAndItsFlight) {
  CrowdSetup setup{.characters = {{}}, .preset = {}};
  setup.trajectories.file = (folder_ / "here" / "walk.csv").string();
  setup.trajectories.reading.walls = (folder_ / "here" / "plans" / "hall.wkt").string();
  setup.camera_path = (folder_ / "here" / "flight.csv").string();
  fs::create_directory(folder_ / "here");
  ASSERT_TRUE(write_crowd_file(folder_ / "here" / "mine.throng", setup));
  fs::rename(folder_ / "here", folder_ / "there");
  const auto moved = read_crowd_file(folder_ / "there" / "mine.throng");
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->trajectories.file, (folder_ / "there/walk.csv").string());
  EXPECT_EQ(moved->trajectories.reading.walls, (folder_ / "there/plans/hall.wkt").string());
  EXPECT_EQ(moved->camera_path, (folder_ / "there/flight.csv").string());
}

TEST_F(CrowdFile, OfACrowdThatComesOnStandardInputReadsItAgain) {
  CrowdSetup setup{.characters = {{}}, .preset = {.tuning = {.scene = Scene::tracks, .agents = 70}, .camera = {}}};
  setup.trajectories.file = "-";
  ASSERT_TRUE(write_crowd_file(folder_ / "mine.throng", setup));
  const DemoOptions options = test::demo((folder_ / "mine.throng").string());
  EXPECT_EQ(options.trajectories.file, "-");
  EXPECT_EQ(options.tuning.agents, 70);
}

// Before crowd files held recorded crowds, such a crowd was lost.
TEST_F(CrowdFile, ThatLacksItsRecordedCrowdIsRefusedUnlessOneIsNamed) {
  const std::string file = (folder_ / "old.throng").string(), walk = (folder_ / "walk.csv").string();
  std::ofstream(file) << R"({"version": 1, "characters": [{}], "values": {"scene": "tracks"}})";
  std::ofstream(walk) << "id,time,x,y\n1,0,0,0\n1,1,1,0\n";
  const auto run = run_program({"--headless=none", file});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_THAT(run.errors, HasSubstr("start with --trajectories FILE"));
  EXPECT_EQ(run_program({"--headless=none", file, "--trajectories", walk}).exit_status, 0);
}

TEST_F(CrowdFile, SaysItsRecordedCrowdAndOptionsSayHowItIsPlayed) {
  CrowdSetup setup{.characters = {{}}, .preset = {.tuning = {.scene = Scene::tracks}, .camera = {}}};
  setup.trajectories = {.file = (folder_ / "walk.csv").string(), .start = 2.0};
  ASSERT_TRUE(write_crowd_file(folder_ / "mine.throng", setup));
  const std::string file = (folder_ / "mine.throng").string();
  EXPECT_EQ(test::demo(file + " --start 3").trajectories.start, 3.0);
  EXPECT_EQ(refusal(file + " --trajectories other.csv"), "--trajectories: " + file + " says it; leave it out");
  EXPECT_EQ(refusal(file + " --agents 3"), "--agents: does not go with --trajectories");
  EXPECT_EQ(refusal(file + " --crowd {}"), "--crowd: " + file + " says it; leave it out");
}

}  // namespace
}  // namespace throng::app::crowd_file_test
