#include "app/settings/preset.h"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/command_line/options.h"
#include "app/settings/tuning_values.h"
#include "tests/app/commands/command_line/command_words.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::preset_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

template <typename Type>
constexpr bool is_optional = false;
template <typename Type>
constexpr bool is_optional<std::optional<Type>> = true;

/// Converts to whatever a member of the struct is, but not to the struct.
template <typename Struct>
struct Anything {
  template <typename Member>
  requires(!std::is_same_v<Member, Struct> && !is_optional<Member>) operator Member() const;
};

template <typename Struct, typename... Members>
constexpr std::size_t members_of() {
  if constexpr (requires { Struct{Members()..., Anything<Struct>()}; }) {
    return members_of<Struct, Members..., Anything<Struct>>();
  }
  return sizeof...(Members);
}

/// A tuning of which no value is the default.
Tuning all_changed() {
  Tuning tuning;
  for (const TuningValue& row : tuning_values()) {
    const std::string before = row.text(tuning);
    for (const char* const text : {"off", "on", "3", "0.3", "2", "stadium", "levels", "inline", "keyframe", "packed",
                                   "all", "interval", "pattern", "cold", "40"}) {
      if (row.text(tuning) == before) row.read(tuning, text);
    }
    EXPECT_NE(row.text(tuning), before) << row.key;
  }
  return tuning;
}

class Presets : public test::TemporaryFolder {
 protected:
  void SetUp() override { setenv("XDG_CONFIG_HOME", folder_.c_str(), 1); }

  fs::path file_with(const std::string& text) const {
    const fs::path file = folder_ / "given.json";
    std::ofstream(file) << text;
    return file;
  }
  std::string refusal_of(const std::string& text) const {
    const auto preset = read_preset(file_with(text));
    return preset ? "(taken)" : preset.error().message;
  }
};

DemoOptions demo(const std::string& line) {
  const ParsedCommand command = parse_command_line(words(line));
  if (const auto* const error = std::get_if<UsageError>(&command)) ADD_FAILURE() << error->message;
  const auto* const options = std::get_if<DemoOptions>(&command);
  return options == nullptr ? DemoOptions{} : *options;
}

std::string refused(const std::string& line) {
  const ParsedCommand command = parse_command_line(words(line));
  const auto* const error = std::get_if<UsageError>(&command);
  return error == nullptr ? "(taken)" : error->message;
}

TEST_F(Presets, HaveAKeyForEveryValueOfTheTuning) {
  constexpr std::size_t own_rules = 4;  // the two limits, which lod_rules() sets, and the importance of the middle
  constexpr std::size_t own_options =
      7;  // the engine's: executor, hash, trace, prefetch, stores, cached bytes, kernels
  constexpr std::size_t more_distances = 2;  // an array of three
  constexpr std::size_t structs = 5;         // lod, system, inspection, light, taken_away
  constexpr std::size_t forced = 3;          // of the inspection; how one looks is not kept
  constexpr std::size_t light = members_of<render::SceneLight>();
  constexpr std::size_t rules = members_of<LodRules>() - own_rules + more_distances;
  constexpr std::size_t options = members_of<anim::SystemOptions>() - own_options - 1 + members_of<anim::CostModel>();
  EXPECT_EQ(tuning_values().size(), members_of<Tuning>() - structs + rules + options + forced + light)
      << "a new member of Tuning needs a row in app/settings/tuning_values.cpp, or presets and recordings forget it";
}

TEST_F(Presets, ReadBackAsTheyWereWritten) {
  const Preset preset{.tuning = all_changed(), .camera = CameraPose{0.1F, 2.0F, -3.3F, 45.5F, -10.0F, 30.0F}};
  const fs::path file = preset_file("evening");
  ASSERT_TRUE(write_preset(file, preset));
  const auto read = read_preset(file);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->tuning, preset.tuning);
  EXPECT_EQ(camera_text(*read->camera), "0.1,2,-3.3,45.5,-10,30");
  EXPECT_THAT(preset_names(), ElementsAre("evening"));
}

TEST_F(Presets, KeepTheDefaultsWhereTheySayNothing) {
  const auto preset = read_preset(file_with(R"({"agents": 20})"));
  ASSERT_TRUE(preset);
  Tuning expected;
  expected.agents = 20;
  EXPECT_EQ(preset->tuning, expected);
  EXPECT_FALSE(preset->camera);
}

TEST_F(Presets, AreRefusedWithFileKeyAndWhatToDo) {
  EXPECT_EQ(refusal_of(R"({"agents": 0})"),
            (folder_ / "given.json: \"agents\" must be a whole number, 1 to 100000").string());
  EXPECT_THAT(refusal_of(R"({"agnts": 5})"), HasSubstr("unknown key \"agnts\"; it knows camera, scene, agents"));
  EXPECT_THAT(refusal_of(R"({"--agents": 5})"), HasSubstr("unknown key"));
  EXPECT_THAT(refusal_of(R"({"scene": "moon"})"),
              HasSubstr("\"scene\" must be plaza, parade, stadium, grid, film or tracks"));
  EXPECT_THAT(refusal_of(R"({"time_scale": 4.5})"), HasSubstr("\"time_scale\" must be a number, 0 to 4"));
  EXPECT_THAT(refusal_of(R"({"smooth": null})"), HasSubstr("\"smooth\" must be a number, a word, true or false"));
  EXPECT_THAT(refusal_of(R"({"camera": "front"})"), HasSubstr("\"camera\" must be x,y,z,yaw,pitch[,fov]"));
  EXPECT_THAT(refusal_of("[]"), HasSubstr("must be a JSON object"));
  EXPECT_THAT(refusal_of(R"({"agents")"), HasSubstr("is not JSON at line 1, column 10; mend it there"));
  EXPECT_THAT(refusal_of(std::string(70'000, '[')), HasSubstr("larger than 64.0 KiB"));
  EXPECT_THAT(read_preset(folder_).error().message, HasSubstr("it is a folder"));
}

TEST_F(Presets, AreStartingValuesThatOptionsWinOver) {
  const std::string file = file_with(R"({"agents": 20, "scene": "grid", "camera": "1,2,3,4,5"})").string();
  const DemoOptions options = demo("--scene parade --preset " + file);
  EXPECT_EQ(options.tuning.agents, 20);
  EXPECT_EQ(options.tuning.scene, Scene::parade);
  EXPECT_EQ(options.camera->z, 3.0F);
  EXPECT_TRUE(options.values_given.all);
  EXPECT_FALSE(demo("--camera above --preset " + file).camera);
}

TEST_F(Presets, AreSetByKeyInTheWordsOfThePresetAndOfTheOption) {
  for (const std::string on : {"true", "on"}) EXPECT_TRUE(demo("--set paused=" + on).tuning.paused) << on;
  for (const std::string off : {"false", "off"}) EXPECT_FALSE(demo("--set variety=" + off).tuning.variety) << off;
  EXPECT_THAT(refused("--set paused=1"), HasSubstr("must be on or off"));
}

TEST_F(Presets, AreFoundByTheirName) {
  ASSERT_TRUE(write_preset(preset_file("few"), {.tuning = demo("--agents 7").tuning, .camera = {}}));
  EXPECT_EQ(demo("--preset few").tuning.agents, 7);
  EXPECT_THAT(refused("--preset many"), HasSubstr("presets/many.json: there is no such file"));
}

TEST_F(Presets, OfLodOffKeepWhatElseTheySay) {
  const std::string file = file_with(R"({"lod": "off", "bone_lod": true})").string();
  EXPECT_TRUE(demo("--preset " + file).tuning.lod.bone_lod);
  EXPECT_FALSE(demo("--lod off --preset " + file).tuning.lod.bone_lod);
}

TEST(SetOption, SetsValuesByTheirKeys) {
  const Tuning tuning = demo("--set full_rate_distance=20.5,paused=on --agents 5").tuning;
  EXPECT_EQ(tuning.lod.full_rate_distance, 20.5F);
  EXPECT_TRUE(tuning.paused);
  EXPECT_EQ(tuning.agents, 5);
}

TEST(SetOption, IsRefusedByKey) {
  EXPECT_THAT(refused("--set speed=2"), HasSubstr("there is no key speed; keys are scene, agents"));
  EXPECT_THAT(refused("--set paused"), HasSubstr("must be KEY=VALUE"));
  EXPECT_THAT(refused("--set time_scale=fast"), HasSubstr("time_scale must be a number, 0 to 4"));
}

TEST(TuningAsOptions, SaysWhatDiffersAndWhatADeviceWouldDecide) {
  EXPECT_EQ(
      command_line({}, {}, {}),
      "--agents 1000 --shadows on --crowd-shade on --frame-rate 30 --set error_px=1,triangle_budget=0,holds_rate=off");
  Tuning tuning;
  tuning.agents = 5000;
  tuning.lod.level_distances[1] = 31.5F;
  EXPECT_EQ(command_line(tuning, {}, CameraPose{0, 2, 9, 0, -5, 50}),
            "--agents 5000 --shadows on --crowd-shade on --frame-rate 30 --set "
            "error_px=1,bone_level_distance_2=31.5,triangle_budget=0,holds_rate=off --camera 0,2,9,0,-5,50");
}

TEST(TuningAsOptions, MakesTheSameTuningAgain) {
  EXPECT_EQ(demo(command_line(all_changed(), {}, {})).tuning, all_changed());
  for (const char* const line : {"--lod off", "--lod off --bone-lod on --mesh-lod 2", "--pus 3 --local-store 64"}) {
    const Tuning tuning = demo(line).tuning;
    EXPECT_EQ(demo(command_line(tuning, {}, {})).tuning, tuning) << line;
  }
  EXPECT_EQ(command_line(demo("--lod off").tuning, {}, {}),
            "--agents 1000 --lod off --shadows on --crowd-shade on --frame-rate 30 --set "
            "error_px=1,triangle_budget=0,holds_rate=off");
}

TEST(TuningAsOptions, SaysByKeyWhatNoOptionTakes) {
  Tuning eight;
  eight.system.tile = 8;
  EXPECT_THAT(command_line({}, eight, {}), HasSubstr(",tile=0"));
}

}  // namespace
}  // namespace throng::app::preset_test
