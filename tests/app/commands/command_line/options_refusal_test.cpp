#include <gtest/gtest.h>

#include "tests/app/commands/command_line/command_words.h"

namespace throng::app::options_refusal_test {
namespace {

class Refusal : public testing::TestWithParam<Refused> {};

TEST_P(Refusal, NamesTheOptionAndWhatIsAllowed) { EXPECT_EQ(refusal(GetParam().line), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    OutOfRange, Refusal,
    testing::Values(
        Refused{"NoAgents", "--agents 0", "--agents 0: must be a whole number, 1 to 100000"},
        Refused{"NegativeAgents", "--agents -1", "--agents -1: must be a whole number, 1 to 100000"},
        Refused{"TooManyAgents", "--agents 100001", "--agents 100001: must be a whole number, 1 to 100000"},
        Refused{"FractionOfAgents", "--agents 1.5", "--agents 1.5: must be a whole number, 1 to 100000"},
        Refused{"OverflowingAgents", "--agents 99999999999",
                "--agents 99999999999: must be a whole number, 1 to 100000"},
        Refused{"NobodySelected", "--select -1", "--select -1: must be a whole number, 0 to 99999"},
        Refused{"NoPus", "--pus 0", "--pus 0: must be a whole number, 1 to 256"},
        Refused{"TooManyPus", "--pus 257", "--pus 257: must be a whole number, 1 to 256"},
        Refused{"NoMemory", "--memory-limit 0", "--memory-limit 0: must be a size, such as 500MB or 2GB"},
        Refused{"MemoryInWords", "--memory-limit much", "--memory-limit much: must be a size, such as 500MB or 2GB"},
        Refused{"MemoryInBits", "--memory-limit 2Gb", "--memory-limit 2Gb: must be a size, such as 500MB or 2GB"},
        Refused{"NoScale", "--scale 0", "--scale 0: must be a number, 1e-06 to 1e+06"},
        Refused{"ScaleOfNobody", "--scale =2", "--scale =2: must be VALUE, or NAME=VALUE with the name of a model"},
        Refused{"NoAxisOfAModel", "--up x,horse=w", "--up x,horse=w: that of horse must be x, y, z, -x, -y or -z"},
        Refused{"NoTint", "--tint 2", "--tint 2: must be a number, 0 to 1"},
        Refused{"NoSizeVariety", "--size-variety 0.5", "--size-variety 0.5: must be a number, 0 to 0.3"},
        Refused{"NoMeshError", "--mesh-error-px -1", "--mesh-error-px -1: must be a number, 0 to 64"},
        Refused{"NoAxis", "--up w", "--up w: must be x, y, z, -x, -y or -z"},
        Refused{"NoGround", "--ground sky", "--ground sky: must be file or feet"},
        Refused{"NegativeSeed", "--seed -1", "--seed -1: must be a whole number, 0 to 4294967295"},
        Refused{"NoSize", "--size 0x0", "--size 0x0: must be WIDTHxHEIGHT in pixels, each 1 to 32767"},
        Refused{"HalfASize", "--size 640", "--size 640: must be WIDTHxHEIGHT in pixels, each 1 to 32767"},
        Refused{"HugeSize", "--size 32768x1", "--size 32768x1: must be WIDTHxHEIGHT in pixels, each 1 to 32767"},
        Refused{"SizeWithATail", "--size 1x1x1", "--size 1x1x1: must be WIDTHxHEIGHT in pixels, each 1 to 32767"},
        Refused{"NoFrames", "--frames 0", "--frames 0: must be a whole number, 1 or more"},
        Refused{"NoStep", "--dt 0", "--dt 0: must be a number, 1e-06 to 3600"},
        Refused{"NegativeStep", "--dt -1", "--dt -1: must be a number, 1e-06 to 3600"},
        Refused{"EndlessStep", "--dt inf", "--dt inf: must be a number, 1e-06 to 3600"},
        Refused{"UndefinedStep", "--dt nan", "--dt nan: must be a number, 1e-06 to 3600"},
        Refused{"OddTile", "--tile 3", "--tile 3: must be 1, 2, 4, 8 or 16"},
        Refused{"NoLocalStore", "--local-store 0", "--local-store 0: must be auto or 1 to 65536 KiB"},
        Refused{"LocalStoreInWords", "--local-store big", "--local-store big: must be auto or 1 to 65536 KiB"},
        Refused{"TwoSamples", "--msaa 2", "--msaa 2: must be 0 or 4"},
        Refused{"EighthMesh", "--mesh-lod 7", "--mesh-lod 7: must be on, off, 0, 1, 2, 3, 4, 5 or 6"},
        Refused{"NegativeTime", "pose a --clip 0 --json - --time 0,-1",
                "--time 0,-1: must be seconds, 0 or more, with commas between them"},
        Refused{"EmptyTime", "pose a --clip 0 --json - --time 0,,1",
                "--time 0,,1: must be seconds, 0 or more, with commas between them"},
        Refused{"NoBones", "bench --bones 0",
                "--bones 0: must be a whole number, 1 to 1024, or several with commas between them"},
        Refused{"NoClips", "bench --clips 0",
                "--clips 0: must be a whole number, 1 to 256, or several with commas between them"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    UnknownWord, Refusal,
    testing::Values(
        Refused{"Scene", "--scene moon", "--scene moon: must be plaza, parade, stadium, grid, film or tracks"},
        Refused{"Schedule", "--schedule none", "--schedule none: must be fused or levels"},
        Refused{"DoubleBuffer", "--double-buffer on", "--double-buffer on: must be off, inline or interleaved"},
        Refused{"Stream", "--stream baked", "--stream baked: must be sampled or keyframe"},
        Refused{"Lod", "--lod on", "--lod on: must be off, distance or budget"},
        Refused{"CameraPath", "--camera-path fly",
                "--camera-path fly: must be none, orbit, pan, or a file that ends in .csv"},
        Refused{"Palette", "--palette half", "--palette half: must be float or packed"},
        Refused{"BoneLod", "--bone-lod 1", "--bone-lod 1: must be on or off"},
        Refused{"Smooth", "--smooth yes", "--smooth yes: must be on or off"},
        Refused{"Shadows", "--shadows soft", "--shadows soft: must be on or off"},
        Refused{"Draw", "--headless --draw first", "--draw first: must be last, all or none"},
        Refused{"Headless", "--headless=glx", "--headless=glx: must be auto, egl, osmesa or none"},
        Refused{"Ui", "--ui=live", "--ui=live: must be measured or fixed"},
        Refused{"Option", "--agent 5", "--agent: unknown option; is --agents meant? throng --help lists them all"},
        Refused{"FarOption", "--wibble", "--wibble: unknown option; throng --help lists them all"},
        Refused{"Command", "benhc --agents 5", "benhc: there is no such command nor file; is throng bench meant?"},
        Refused{"ShortOption", "-a", "-a: unknown option; throng --help lists them all"},
        Refused{"OptionOfAnotherCommand", "pose a --clip 0 --time 0 --json - --pus 2",
                "--pus: unknown option; throng pose --help lists them all"},
        Refused{"SecondModel", "inspect a.glb b.glb",
                "b.glb: unexpected; options begin with --, and one model is the most"},
        Refused{"ModelTooMany",
                "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 q.glb",
                "q.glb: 30 models are the most"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Limits, Refusal,
    testing::Values(Refused{"NoPixels", "--error-px 0", "--error-px 0: must be a number of pixels above 0"},
                    Refused{"PixelsInWords", "--error-px one", "--error-px one: must be a number of pixels above 0"},
                    Refused{"NoTime", "--budget-ms -2", "--budget-ms -2: must be a number of milliseconds above 0"},
                    Refused{"PixelsByDistance", "--lod distance --error-px 1", "--error-px: goes with --lod budget"},
                    Refused{"TimeWithoutLevelOfDetail", "--lod off --budget-ms 4",
                            "--budget-ms: goes with --lod budget"}),
    name_of);

const std::string roles =
    "roles are stand, look_around, walk, jog, run, wave, cheer, clap, sit, walk_back, step_left, step_right, "
    "shuffle, step_in_place, veer_left, veer_right, talk, phone, call, drink, take_picture, lean, sit_on_step, carry, "
    "hold_up, hold_phone, lead, led, push and stick";

INSTANTIATE_TEST_SUITE_P(
    Clips, Refusal,
    testing::Values(
        Refused{"UnknownRole", "--clips fly=Idle", "--clips fly=Idle: there is no role fly; " + roles},
        Refused{"RoleAlone", "--clips walk", "--clips walk: must be ROLE=NAME, with commas between several; " + roles},
        Refused{"NoName", "--clips walk=", "--clips walk=: must be ROLE=NAME, with commas between several; " + roles},
        Refused{"CommaAtTheEnd", "--clips walk=Walk,",
                "--clips walk=Walk,: must be ROLE=NAME, with commas between several; " + roles},
        Refused{"Twice", "--clips walk=A,walk=B", "--clips walk=A,walk=B: walk is given twice"}),
    name_of);

constexpr const char* camera_rule =
    ": must be a camera's name or x,y,z,yaw,pitch[,fov]: metres, degrees, none beyond a million, pitch -90 to 90, fov "
    "1 to 170";

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
        Refused{"FlagTwice", "--hide-ui --hide-ui", "--hide-ui: given more than once"},
        Refused{"HeadlessTwice", "--headless --headless=egl", "--headless: given more than once"},
        Refused{"FlagWithAValue", "--hide-ui=no", "--hide-ui: takes no value"},
        Refused{"PictureOfNothing", "--headless=none --screenshot a.png",
                "--screenshot: --headless=none draws nothing; use --headless"},
        Refused{"DrawnWithoutGl", "--headless=none --draw all",
                "--draw: --headless=none draws nothing; use --headless"},
        Refused{"OverlayWithoutGl", "--headless=none --ui", "--ui: --headless=none draws nothing; use --headless"},
        Refused{"PictureOfNoFrame", "--headless --draw none --screenshot a.png",
                "--screenshot: --draw none draws nothing"},
        Refused{"WindowOfAHugeSize", "--size 16385x1",
                "--size: a window has at most 16384 pixels a side; use --headless"},
        Refused{"WindowThatDrawsOnce", "--draw last", "--draw: a window draws all; use --headless"},
        Refused{"OverlayShownAndHidden", "--ui --hide-ui", "--ui excludes --hide-ui; give one of them"},
        Refused{"OverlayThatNobodySees", "--headless --ui",
                "--ui: no frame is drawn; add --screenshot, --ui-map or --draw last"},
        Refused{"LegendOfAWindow", "--legend", "--legend: a window has it in its panel; add --headless"},
        Refused{"LegendWithoutGl", "--headless=none --legend",
                "--legend: --headless=none draws nothing; use --headless"},
        Refused{"LegendThatNobodySees", "--headless --legend",
                "--legend: no frame is drawn; add --screenshot, --ui-map or --draw last"},
        Refused{"LegendTwice", "--headless --legend --ui --screenshot a.png",
                "--ui excludes --legend; give one of them"},
        Refused{"AnotherView", "--colours age",
                "--colours age: must be none, interval, bones, mesh, error, speed, density or presence"},
        Refused{"TrailsOfTooLong", "--trails 31", "--trails 31: must be a number, 0 to 30"},
        Refused{"OverlayOfNoFrame", "--headless --ui --draw none", "--ui: --draw none draws nothing"},
        Refused{"MapOfNoFrame", "--headless --ui --ui-map a.json --draw none", "--ui: --draw none draws nothing"},
        Refused{"MapOfNoOverlay", "--headless --ui-map a.json", "--ui-map: no overlay is drawn; add --ui"},
        Refused{"CastBesideModels", "a.glb --cast b.glb", "--cast: takes the place of MODEL; give one of them"},
        Refused{"SkinOfNobody", "--skin all", "--skin: goes with a MODEL or --cast"},
        Refused{"CastOfAReplay", "--replay a.rec --cast b.glb",
                "--cast: the recording says it; leave it out with --replay"},
        Refused{"NoShare", "--cast a.glb*0",
                "--cast a.glb*0: the share of a.glb must be a number, 0.01 to 10000, as in a.glb*2"},
        Refused{"OddVariety", "--variety some", "--variety some: must be on or off"},
        Refused{"DataThatIsNotThere", "--data no/such/folder", "--data no/such/folder: must be a folder that is there"},
        Refused{"PictureThatIsNoPng", "--headless --screenshot a.jpg",
                "--screenshot a.jpg: must be a file name that ends in .png"},
        Refused{"PictureToStandardOutput", "--headless --screenshot -",
                "--screenshot -: must be a file name that ends in .png"},
        Refused{"MapToStandardOutput", "--headless --ui --ui-map -",
                "--ui-map -: must be a file; it is not written to standard output"},
        Refused{"FocusOfAWindow", "--focus 5", "--focus: is for stills; use --headless and --screenshot"},
        Refused{"FocusOfEachFrame", "--focus 5 --headless --draw all --screenshot a.png",
                "--focus: is for stills; use --headless and --screenshot"},
        Refused{"ApertureWithoutFocus", "--aperture 2 --headless --screenshot a.png", "--aperture: goes with --focus"},
        Refused{"DrawAndBones", "bench --draw --bones 5", "--bones excludes --draw; give one of them"},
        Refused{"SceneWithoutDraw", "bench --scene grid", "--scene: goes with --draw"},
        Refused{"TileWithDraw", "bench --draw --tile 16",
                "--tile: --draw measures what a run does by itself; leave it out"},
        Refused{"PusWithDraw", "bench --draw --pus 1,2", "--pus: one number goes with --draw"},
        Refused{"EmptyPartOfAList", "bench --agents 10,,20",
                "--agents 10,,20: must be a whole number, 1 to 100000, or several with commas between them"},
        Refused{"UnknownWordInAList", "bench --schedule fused,lanes",
                "--schedule fused,lanes: must be fused or levels, or several with commas between them"},
        Refused{"PlotThatIsNoSvg", "bench --plot a.png", "--plot a.png: must be a file name that ends in .svg"},
        Refused{"BonesOfAModel", "bench a.glb --bones 5", "MODEL excludes --bones; give one of them"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Bake, Refusal,
                         testing::Values(Refused{"WithoutAModel", "bake -o a.pack", "MODEL is required"},
                                         Refused{"WithoutAPack", "bake a.glb", "-o is required"},
                                         Refused{"BuiltInAndAModel", "bake --built-in a.glb -o a.pack",
                                                 "MODEL excludes --built-in; give one of them"},
                                         Refused{"BuiltInOfAnotherSize", "bake --built-in --scale 2 -o a.pack",
                                                 "--scale excludes --built-in; give one of them"},
                                         Refused{"IntoAnotherKindOfFile", "bake a.glb -o a.glb",
                                                 "-o a.glb: must be a file name that ends in .pack"}),
                         name_of);

TEST(EmptyText, IsRefusedWhereANameIsDue) {
  EXPECT_EQ(refusal_of({""}), "MODEL : must not be empty");
  EXPECT_EQ(refusal_of({"--camera", ""}), "--camera : must not be empty");
  EXPECT_EQ(refusal_of({"--stats", ""}), "--stats : must not be empty");
}

}  // namespace
}  // namespace throng::app::options_refusal_test
