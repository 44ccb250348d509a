#include "app/options.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The words of a line, as a shell would part them where nothing is quoted.
std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

template <typename Options>
Options accepted(const std::string& line) {
  const ParsedCommand command = parse_command_line(words(line));
  if (const auto* const error = std::get_if<UsageError>(&command)) ADD_FAILURE() << line << ": " << error->message;
  const auto* const options = std::get_if<Options>(&command);
  return options == nullptr ? Options{} : *options;
}

DemoOptions demo(const std::string& line) { return accepted<DemoOptions>(line); }

std::string refusal_of(const std::vector<std::string>& arguments) {
  const ParsedCommand command = parse_command_line(arguments);
  const auto* const error = std::get_if<UsageError>(&command);
  return error == nullptr ? "(accepted)" : error->message;
}

std::string refusal(const std::string& line) { return refusal_of(words(line)); }

std::string shown(const std::string& line) {
  const ParsedCommand command = parse_command_line(words(line));
  const auto* const text = std::get_if<ShowText>(&command);
  return text == nullptr ? "(nothing)" : text->text;
}

TEST(DemoDefaults, AreThoseOfTheHelp) {
  const DemoOptions options = demo("");
  EXPECT_EQ(options.model, "");
  EXPECT_EQ(options.context, ContextKind::window);
  EXPECT_EQ(options.draw, std::nullopt);
  EXPECT_EQ(options.frames, 60);
  EXPECT_FALSE(options.frames_given);
  EXPECT_EQ(options.dt, std::nullopt);
  EXPECT_EQ(options.width, 1280);
  EXPECT_EQ(options.height, 720);
  EXPECT_FALSE(options.ui || options.ui_fixed || options.hide_ui);
  EXPECT_EQ(options.msaa, -1);
  EXPECT_TRUE(options.shadows);
  EXPECT_FALSE(options.agents_given || options.shadows_given);
  EXPECT_FALSE(options.camera.has_value());
  EXPECT_EQ(options.camera_name + options.screenshot + options.stats + options.ui_map, "");
}

TEST(DemoDefaults, TuneTheCrowd) {
  const Tuning tuning = demo("").tuning;
  EXPECT_EQ(tuning.scene, Scene::plaza);
  EXPECT_EQ(tuning.agents, 1000);
  EXPECT_EQ(tuning.seed, 1U);
  EXPECT_EQ(tuning.lod, LodRule::distance);
  EXPECT_TRUE(tuning.bone_lod);
  EXPECT_TRUE(tuning.smooth);
  EXPECT_EQ(tuning.mesh_lod, -1);
  EXPECT_EQ(tuning.pus, 0);
  EXPECT_EQ(tuning.local_store_kib, 0);
  EXPECT_EQ(tuning.tile, 0);
  EXPECT_EQ(tuning.schedule, Schedule::fused);
  EXPECT_EQ(tuning.double_buffer, DoubleBuffer::interleaved);
  EXPECT_EQ(tuning.stream, Stream::sampled);
}

TEST(DemoOptions, TuneTheCrowd) {
  const Tuning tuning =
      demo(
          "--agents 7 --scene grid --seed 4294967295 --pus 3 --local-store 128 --schedule levels --tile 8 "
          "--double-buffer inline --stream keyframe --bone-lod off --smooth off --mesh-lod 2")
          .tuning;
  EXPECT_EQ(tuning.agents, 7);
  EXPECT_EQ(tuning.scene, Scene::grid);
  EXPECT_EQ(tuning.seed, 4294967295U);
  EXPECT_EQ(tuning.pus, 3);
  EXPECT_EQ(tuning.local_store_kib, 128);
  EXPECT_EQ(tuning.schedule, Schedule::levels);
  EXPECT_EQ(tuning.tile, 8);
  EXPECT_EQ(tuning.double_buffer, DoubleBuffer::inline_copy);
  EXPECT_EQ(tuning.stream, Stream::keyframe);
  EXPECT_FALSE(tuning.bone_lod);
  EXPECT_FALSE(tuning.smooth);
  EXPECT_EQ(tuning.mesh_lod, 2);
}

TEST(DemoOptions, SayWhatIsDrawnAndWritten) {
  const DemoOptions options = demo(
      "model.glb --headless=osmesa --draw all --frames 5 --dt 0.5 --size 640x360 --ui=fixed --msaa 4 --shadows off "
      "--screenshot a.png --stats b.json --ui-map c.json --data .");
  EXPECT_EQ(options.model, "model.glb");
  EXPECT_EQ(options.context, ContextKind::osmesa);
  EXPECT_EQ(options.draw, DrawWhich::all);
  EXPECT_EQ(options.frames, 5);
  EXPECT_TRUE(options.frames_given);
  EXPECT_EQ(options.dt, 0.5);
  EXPECT_EQ(options.width, 640);
  EXPECT_EQ(options.height, 360);
  EXPECT_TRUE(options.ui && options.ui_fixed);
  EXPECT_EQ(options.msaa, 4);
  EXPECT_FALSE(options.shadows);
  EXPECT_TRUE(options.shadows_given);
  EXPECT_THAT((std::vector{options.screenshot, options.stats, options.ui_map, options.data}),
              ElementsAre("a.png", "b.json", "c.json", "."));
}

TEST(OptionalValue, IsTakenOnlyAfterAnEqualsSign) {
  const DemoOptions before_a_model = demo("--headless model.glb");
  EXPECT_EQ(before_a_model.context, ContextKind::headless_default);
  EXPECT_EQ(before_a_model.model, "model.glb");
  EXPECT_EQ(demo("--headless egl").model, "egl");
  EXPECT_EQ(demo("--headless=egl").context, ContextKind::egl);
  EXPECT_EQ(demo("--headless=none").context, ContextKind::none);
  EXPECT_EQ(demo("--headless --ui fixed").model, "fixed");
  EXPECT_FALSE(demo("--headless --ui").ui_fixed);
}

TEST(RequiredValue, IsTakenAfterASpaceOrAnEqualsSign) {
  EXPECT_EQ(demo("--agents 5").tuning.agents, 5);
  EXPECT_EQ(demo("--agents=5").tuning.agents, 5);
}

TEST(LodOff, TurnsOffAllThatOnlySavesWork) {
  const Tuning tuning = demo("--lod off").tuning;
  EXPECT_EQ(tuning.lod, LodRule::off);
  EXPECT_FALSE(tuning.bone_lod);
  EXPECT_FALSE(tuning.smooth);
  EXPECT_EQ(tuning.mesh_lod, 0);
}

TEST(LodOff, LeavesWhatIsAskedForInWords) {
  const Tuning tuning = demo("--bone-lod on --lod off --mesh-lod 3").tuning;
  EXPECT_TRUE(tuning.bone_lod);
  EXPECT_FALSE(tuning.smooth);
  EXPECT_EQ(tuning.mesh_lod, 3);
}

TEST(MeshLod, IsBySizeFinestOrOneOfFour) {
  EXPECT_EQ(demo("--mesh-lod on").tuning.mesh_lod, -1);
  EXPECT_EQ(demo("--mesh-lod off").tuning.mesh_lod, 0);
  EXPECT_EQ(demo("--mesh-lod 3").tuning.mesh_lod, 3);
}

TEST(Camera, IsANameOrAPlace) {
  EXPECT_EQ(demo("--camera above").camera_name, "above");
  const auto place = demo("--camera -1,2,3.5,-90,10").camera;
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->x, -1);
  EXPECT_EQ(place->y, 2);
  EXPECT_EQ(place->z, 3.5F);
  EXPECT_EQ(place->yaw, -90);
  EXPECT_EQ(place->pitch, 10);
  EXPECT_EQ(place->field_of_view, 50);
  EXPECT_EQ(demo("--camera 1,2,3,4,5,60").camera->field_of_view, 60);
}

TEST(Pose, TakesModelClipTimesAndFile) {
  const auto options = accepted<PoseOptions>("pose model.glb --clip walk --time 0,0.25,1 --stream keyframe --json -");
  EXPECT_EQ(options.model, "model.glb");
  EXPECT_EQ(options.clip, "walk");
  EXPECT_THAT(options.times, ElementsAre(0, 0.25, 1));
  EXPECT_EQ(options.stream, Stream::keyframe);
  EXPECT_EQ(options.json, "-");
}

TEST(Inspect, TakesAModel) {
  EXPECT_FALSE(accepted<InspectOptions>("inspect model.glb").json);
  const auto options = accepted<InspectOptions>("inspect --json model.glb");
  EXPECT_TRUE(options.json);
  EXPECT_EQ(options.model, "model.glb");
}

TEST(Bench, HasDefaults) {
  const auto options = accepted<BenchOptions>("bench");
  EXPECT_EQ(options.model, "");
  EXPECT_EQ(options.agents, 1000);
  EXPECT_EQ(options.bones, 62);
  EXPECT_EQ(options.clips, 2);
  EXPECT_EQ(options.frames, 60);
  EXPECT_EQ(options.pus + options.local_store_kib + options.tile, 0);
  EXPECT_EQ(options.schedule, Schedule::fused);
  EXPECT_EQ(options.stream, Stream::sampled);
  EXPECT_EQ(options.double_buffer, DoubleBuffer::interleaved);
  EXPECT_EQ(options.json, "");
}

TEST(Bench, TakesTheSchedulingOptionsOfTheDemo) {
  const auto options = accepted<BenchOptions>(
      "bench --agents 10000 --bones 30 --clips 5 --pus 2 --schedule levels --stream keyframe --local-store auto --tile "
      "16 "
      "--double-buffer off --frames 9 --json -");
  EXPECT_EQ(options.agents, 10000);
  EXPECT_EQ(options.bones, 30);
  EXPECT_EQ(options.clips, 5);
  EXPECT_EQ(options.pus, 2);
  EXPECT_EQ(options.schedule, Schedule::levels);
  EXPECT_EQ(options.stream, Stream::keyframe);
  EXPECT_EQ(options.tile, 16);
  EXPECT_EQ(options.double_buffer, DoubleBuffer::off);
  EXPECT_EQ(options.frames, 9);
  EXPECT_EQ(options.json, "-");
}

TEST(Help, IsThereForEveryCommand) {
  EXPECT_THAT(shown("--help"), HasSubstr("Usage: throng [MODEL] [options]"));
  EXPECT_THAT(shown("-h"), HasSubstr("--headless[=egl|osmesa|none]"));
  EXPECT_THAT(shown("pose --help"),
              HasSubstr("Usage: throng pose MODEL --clip NAME|INDEX --time T[,T...] --json FILE|-"));
  EXPECT_THAT(shown("inspect --help"), HasSubstr("Usage: throng inspect MODEL"));
  EXPECT_THAT(shown("bench --help"), HasSubstr("Usage: throng bench [MODEL]"));
}

TEST(Help, PromisesNothingThatIsNotBuilt) {
  EXPECT_THAT(shown("--help"), testing::Not(HasSubstr("--record")));
  EXPECT_THAT(shown("--help"), testing::Not(HasSubstr("budget")));
}

TEST(Version, NamesTheProgram) { EXPECT_THAT(shown("--version"), testing::StartsWith("throng ")); }

struct Refused {
  std::string name;
  std::string line;
  std::string message;
};

class Refusal : public testing::TestWithParam<Refused> {};

TEST_P(Refusal, NamesTheOptionAndWhatIsAllowed) { EXPECT_EQ(refusal(GetParam().line), GetParam().message); }

std::string name_of(const testing::TestParamInfo<Refused>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(
    OutOfRange, Refusal,
    testing::Values(
        Refused{"NoAgents", "--agents 0", "--agents 0: must be a whole number, 1 to 100000"},
        Refused{"NegativeAgents", "--agents -1", "--agents -1: must be a whole number, 1 to 100000"},
        Refused{"TooManyAgents", "--agents 100001", "--agents 100001: must be a whole number, 1 to 100000"},
        Refused{"FractionOfAgents", "--agents 1.5", "--agents 1.5: must be a whole number, 1 to 100000"},
        Refused{"OverflowingAgents", "--agents 99999999999",
                "--agents 99999999999: must be a whole number, 1 to 100000"},
        Refused{"NoPus", "--pus 0", "--pus 0: must be a whole number, 1 to 256"},
        Refused{"TooManyPus", "--pus 257", "--pus 257: must be a whole number, 1 to 256"},
        Refused{"NegativeSeed", "--seed -1", "--seed -1: must be a whole number, 0 to 4294967295"},
        Refused{"NoSize", "--size 0x0", "--size 0x0: must be WIDTHxHEIGHT in pixels, each 1 to 16384"},
        Refused{"HalfASize", "--size 640", "--size 640: must be WIDTHxHEIGHT in pixels, each 1 to 16384"},
        Refused{"HugeSize", "--size 16385x1", "--size 16385x1: must be WIDTHxHEIGHT in pixels, each 1 to 16384"},
        Refused{"SizeWithATail", "--size 1x1x1", "--size 1x1x1: must be WIDTHxHEIGHT in pixels, each 1 to 16384"},
        Refused{"NoFrames", "--frames 0", "--frames 0: must be a whole number, 1 or more"},
        Refused{"NoStep", "--dt 0", "--dt 0: must be a number of seconds above 0"},
        Refused{"NegativeStep", "--dt -1", "--dt -1: must be a number of seconds above 0"},
        Refused{"EndlessStep", "--dt inf", "--dt inf: must be a number of seconds above 0"},
        Refused{"UndefinedStep", "--dt nan", "--dt nan: must be a number of seconds above 0"},
        Refused{"OddTile", "--tile 3", "--tile 3: must be 1, 2, 4, 8 or 16"},
        Refused{"NoLocalStore", "--local-store 0", "--local-store 0: must be auto or 1 to 65536 KiB"},
        Refused{"LocalStoreInWords", "--local-store big", "--local-store big: must be auto or 1 to 65536 KiB"},
        Refused{"TwoSamples", "--msaa 2", "--msaa 2: must be 0 or 4"},
        Refused{"FifthMesh", "--mesh-lod 4", "--mesh-lod 4: must be on, off, 0, 1, 2 or 3"},
        Refused{"NegativeTime", "pose a --clip 0 --json - --time 0,-1",
                "--time 0,-1: must be seconds, 0 or more, with commas between them"},
        Refused{"EmptyTime", "pose a --clip 0 --json - --time 0,,1",
                "--time 0,,1: must be seconds, 0 or more, with commas between them"},
        Refused{"NoBones", "bench --bones 0", "--bones 0: must be a whole number, 1 to 1024"},
        Refused{"NoClips", "bench --clips 0", "--clips 0: must be a whole number, 1 to 256"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    UnknownWord, Refusal,
    testing::Values(
        Refused{"Scene", "--scene moon", "--scene moon: must be plaza or grid"},
        Refused{"Schedule", "--schedule none", "--schedule none: must be fused or levels"},
        Refused{"DoubleBuffer", "--double-buffer on", "--double-buffer on: must be off, inline or interleaved"},
        Refused{"Stream", "--stream baked", "--stream baked: must be sampled or keyframe"},
        Refused{"Lod", "--lod on", "--lod on: must be off or distance"},
        Refused{"BoneLod", "--bone-lod 1", "--bone-lod 1: must be on or off"},
        Refused{"Smooth", "--smooth yes", "--smooth yes: must be on or off"},
        Refused{"Shadows", "--shadows soft", "--shadows soft: must be on or off"},
        Refused{"Draw", "--headless --draw first", "--draw first: must be last, all or none"},
        Refused{"Headless", "--headless=glx", "--headless=glx: must be auto, egl, osmesa or none"},
        Refused{"Ui", "--ui=live", "--ui=live: must be measured or fixed"},
        Refused{"Option", "--agent 5", "--agent: unknown option; throng --help lists them all"},
        Refused{"ShortOption", "-a", "-a: unknown option; throng --help lists them all"},
        Refused{"OptionOfAnotherCommand", "pose a --clip 0 --time 0 --json - --pus 2",
                "--pus: unknown option; throng pose --help lists them all"},
        Refused{"SecondModel", "a.glb b.glb", "b.glb: unexpected; options begin with --, and one model is the most"}),
    name_of);

constexpr const char* camera_rule =
    ": must be a camera's name or x,y,z,yaw,pitch[,fov]: metres, degrees, pitch -90 to 90, fov 1 to 170";

INSTANTIATE_TEST_SUITE_P(
    Camera, Refusal,
    testing::Values(
        Refused{"TooFewNumbers", "--camera 1,2,3,4", std::string("--camera 1,2,3,4") + camera_rule},
        Refused{"TooManyNumbers", "--camera 1,2,3,4,5,6,7", std::string("--camera 1,2,3,4,5,6,7") + camera_rule},
        Refused{"NotANumber", "--camera 1,2,3,4,x", std::string("--camera 1,2,3,4,x") + camera_rule},
        Refused{"LooksOverItsHead", "--camera 1,2,3,4,91", std::string("--camera 1,2,3,4,91") + camera_rule},
        Refused{"SeesAllAround", "--camera 1,2,3,4,5,180", std::string("--camera 1,2,3,4,5,180") + camera_rule},
        Refused{"Infinite", "--camera inf,2,3,4,5", std::string("--camera inf,2,3,4,5") + camera_rule}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Missing, Refusal,
                         testing::Values(Refused{"Value", "--agents", "--agents: a value is missing"},
                                         Refused{"ValueAfterEquals",
                                                 "--headless=", "--headless: a value is missing after ="},
                                         Refused{"Model", "pose", "MODEL is required"},
                                         Refused{"Clip", "pose a.glb --time 0 --json -", "--clip is required"},
                                         Refused{"Time", "pose a.glb --clip 0 --json -", "--time is required"},
                                         Refused{"Json", "pose a.glb --clip 0 --time 0", "--json is required"},
                                         Refused{"ModelToInspect", "inspect", "MODEL is required"}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(
    Contradiction, Refusal,
    testing::Values(
        Refused{"Twice", "--agents 3 --agents 4", "--agents: given more than once"},
        Refused{"HeadlessTwice", "--headless --headless=egl", "--headless: given more than once"},
        Refused{"FlagWithAValue", "--hide-ui=no", "--hide-ui=no: takes no value"},
        Refused{"PictureOfNothing", "--headless=none --screenshot a.png",
                "--screenshot: --headless=none draws nothing; use --headless"},
        Refused{"DrawnWithoutGl", "--headless=none --draw all",
                "--draw: --headless=none draws nothing; use --headless"},
        Refused{"OverlayWithoutGl", "--headless=none --ui", "--ui: --headless=none draws nothing; use --headless"},
        Refused{"PictureOfNoFrame", "--headless --draw none --screenshot a.png",
                "--screenshot: --draw none draws nothing"},
        Refused{"WindowThatDrawsOnce", "--draw last", "--draw: a window draws all; use --headless"},
        Refused{"OverlayShownAndHidden", "--ui --hide-ui", "--ui: contradicts --hide-ui; give one of them"},
        Refused{"MapOfNoOverlay", "--headless --ui-map a.json", "--ui-map: no overlay is drawn; add --ui"},
        Refused{"DataThatIsNotThere", "--data no/such/folder", "--data no/such/folder: must be a folder that is there"},
        Refused{"PictureThatIsNoPng", "--headless --screenshot a.jpg",
                "--screenshot a.jpg: must be a file name that ends in .png"},
        Refused{"BonesOfAModel", "bench a.glb --bones 5", "--bones: a model brings its own; give one or the other"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    NotBuiltYet, Refusal,
    testing::Values(Refused{"Parade", "--scene parade", "--scene parade: is not built yet; must be plaza or grid"},
                    Refused{"Stadium", "--scene stadium", "--scene stadium: is not built yet; must be plaza or grid"},
                    Refused{"Budget", "--lod budget", "--lod budget: is not built yet; must be off or distance"},
                    Refused{"Milliseconds", "--budget-ms 4", "--budget-ms 4: is not built yet"},
                    Refused{"Pixels", "--error-px 2", "--error-px 2: is not built yet"},
                    Refused{"Recording", "--record run", "--record run: is not built yet"},
                    Refused{"Trace", "--trace a.json", "--trace a.json: is not built yet"},
                    Refused{"Preset", "--preset a.json", "--preset a.json: is not built yet"},
                    Refused{"Replay", "--replay run", "--replay run: is not built yet"},
                    Refused{"Machine", "bench --machine box", "--machine box: is not built yet"},
                    Refused{"Baking", "bake model.glb -o model.pack", "bake: is not built yet"}),
    name_of);

TEST(EmptyText, IsRefusedWhereANameIsDue) {
  EXPECT_EQ(refusal_of({""}), "MODEL : must not be empty");
  EXPECT_EQ(refusal_of({"--camera", ""}), "--camera : must not be empty");
  EXPECT_EQ(refusal_of({"--stats", ""}), "--stats : must not be empty");
}

TEST(ValueOfAnOption, MayBeginWithDashes) { EXPECT_EQ(demo("--stats --odd-name.json").stats, "--odd-name.json"); }

}  // namespace
}  // namespace throng::app
