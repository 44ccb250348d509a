#include "app/commands/command_line/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/commands/command_line/command_words.h"

namespace throng::app::options_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

template <typename Options>
Options accepted(const std::string& line) {
  const ParsedCommand command = parse_command_line(words(line));
  if (const auto* const error = std::get_if<UsageError>(&command)) ADD_FAILURE() << line << ": " << error->message;
  const auto* const options = std::get_if<Options>(&command);
  return options == nullptr ? Options{} : *options;
}

DemoOptions demo(const std::string& line) { return accepted<DemoOptions>(line); }

std::string shown(const std::string& line) {
  const ParsedCommand command = parse_command_line(words(line));
  const auto* const text = std::get_if<ShowText>(&command);
  return text == nullptr ? "(nothing)" : text->text;
}

TEST(DemoDefaults, AreThoseOfTheHelp) {
  const DemoOptions options = demo("");
  EXPECT_TRUE(options.models.empty());
  EXPECT_EQ(options.context, ContextKind::window);
  EXPECT_EQ(options.draw, std::nullopt);
  EXPECT_EQ(options.frames, 60);
  EXPECT_FALSE(options.frames_given);
  EXPECT_EQ(options.dt, std::nullopt);
  EXPECT_EQ(options.width, 1280);
  EXPECT_EQ(options.height, 720);
  EXPECT_FALSE(options.ui || options.ui_fixed || options.hide_ui);
  EXPECT_EQ(options.msaa, -1);
  EXPECT_TRUE(options.tuning.shadows);
  EXPECT_FALSE(options.values_given.all);
  EXPECT_THAT(options.values_given.keys, IsEmpty());
  EXPECT_FALSE(options.camera.has_value());
  EXPECT_EQ(options.camera_name + options.screenshot + options.stats + options.ui_map, "");
}

TEST(DemoDefaults, DrawTheLastFrameWhereItIsSeenAndNoneElse) {
  EXPECT_EQ(drawn_frames(demo("--headless")), DrawWhich::none);
  EXPECT_EQ(drawn_frames(demo("--headless --screenshot a.png")), DrawWhich::last);
  EXPECT_EQ(drawn_frames(demo("--headless --ui --ui-map a.json")), DrawWhich::last);
  EXPECT_EQ(drawn_frames(demo("--headless --screenshot a.png --draw all")), DrawWhich::all);
  EXPECT_EQ(drawn_frames(demo("--headless --ui --draw last")), DrawWhich::last);
}

TEST(DemoDefaults, TuneTheCrowd) {
  const Tuning tuning = demo("").tuning;
  EXPECT_EQ(tuning.scene, Scene::plaza);
  EXPECT_EQ(tuning.agents, 1000);
  EXPECT_EQ(tuning.seed, 1U);
  EXPECT_EQ(tuning.lod.rule, LodRule::budget);
  EXPECT_TRUE(tuning.lod.bone_lod);
  EXPECT_TRUE(tuning.lod.smooth);
  EXPECT_EQ(tuning.mesh_lod, -1);
  EXPECT_EQ(tuning.system.pus, 0);
  EXPECT_EQ(local_store_kib(tuning), 0);
  EXPECT_EQ(tuning.system.tile, 0);
  EXPECT_EQ(tuning.system.schedule, anim::Schedule::fused);
  EXPECT_EQ(tuning.system.double_buffering, anim::DoubleBuffering::interleaved);
  EXPECT_EQ(tuning.system.stream, anim::StreamKind::sampled);
}

TEST(DemoOptions, NameEveryScene) {
  EXPECT_EQ(demo("--scene plaza").tuning.scene, Scene::plaza);
  EXPECT_EQ(demo("--scene parade").tuning.scene, Scene::parade);
  EXPECT_EQ(demo("--scene stadium").tuning.scene, Scene::stadium);
}

TEST(DemoOptions, SayWhichClipsPlayWhichRoles) {
  EXPECT_TRUE(demo("").clips.empty());
  const std::vector<RoleChoice> expected{{Role::walk, "Walking_B"}, {Role::look_around, "a=b"}, {Role::sit, "none"}};
  EXPECT_EQ(demo("--clips walk=Walking_B,look_around=a=b,sit=none").clips, expected);
}

TEST(DemoOptions, SayInWhatSizeAndWhereModelsStand) {
  const anim::PlacementChoice chosen = demo("--scale 0.01 --up -z --ground feet").placement;
  EXPECT_EQ(chosen,
            (anim::PlacementChoice{.scale = 0.01, .up = anim::UpAxis::minus_z, .ground = anim::GroundRule::feet}));
  EXPECT_EQ(demo("").placement, anim::PlacementChoice{});
}

TEST(DemoOptions, SayItOfSingleModelsByName) {
  const DemoOptions options = demo("a.glb b=2.glb --scale 2,a=0.01 --up b=2=z,a.glb=-x --ground a=feet");
  EXPECT_EQ(options.placement, anim::PlacementChoice{.scale = 2.0});
  const std::vector<ModelPlacement> expected{{.model = "a", .scale = 0.01},
                                             {.model = "b=2", .up = anim::UpAxis::z},
                                             {.model = "a.glb", .up = anim::UpAxis::minus_x},
                                             {.model = "a", .ground = anim::GroundRule::feet}};
  EXPECT_EQ(options.placements, expected);
}

TEST(DemoOptions, SayHowMuchMemoryReadingTakes) {
  EXPECT_EQ(demo("").reading.memory_limit, 0U) << "as the import says";
  EXPECT_EQ(demo("--memory-limit 2GB").reading.memory_limit, 2'000'000'000U);
  EXPECT_EQ(demo("--memory-limit 1.5MB").reading.memory_limit, 1'500'000U);
  EXPECT_EQ(demo("--memory-limit 64MiB").reading.memory_limit, 64U << 20U);
  EXPECT_EQ(demo("--memory-limit 4096").reading.memory_limit, 4096U);
}

TEST(EveryCommandThatReadsModels, TakesALimitOfMemory) {
  const std::string limit = " --memory-limit 1KB";
  EXPECT_EQ(accepted<InspectOptions>("inspect a.glb" + limit).reading.memory_limit, 1000U);
  EXPECT_EQ(accepted<BakeOptions>("bake a.glb -o a.pack" + limit).reading.memory_limit, 1000U);
  EXPECT_EQ(accepted<LodOptions>("lod a.glb" + limit).reading.memory_limit, 1000U);
  EXPECT_EQ(accepted<BenchOptions>("bench a.glb" + limit).reading.memory_limit, 1000U);
  EXPECT_EQ(accepted<PoseOptions>("pose a.glb --clip 0 --time 0 --json -" + limit).reading.memory_limit, 1000U);
}

TEST(DemoOptions, TuneTheCrowd) {
  const Tuning tuning =
      demo(
          "--agents 7 --scene grid --seed 4294967295 --pus 3 --local-store 128 --schedule levels --tile 8 "
          "--double-buffer inline --stream keyframe --palette packed --bone-lod off --smooth off --mesh-lod 2")
          .tuning;
  EXPECT_EQ(tuning.agents, 7);
  EXPECT_EQ(tuning.scene, Scene::grid);
  EXPECT_EQ(tuning.seed, 4294967295U);
  EXPECT_EQ(tuning.system.pus, 3);
  EXPECT_EQ(local_store_kib(tuning), 128);
  EXPECT_EQ(tuning.system.schedule, anim::Schedule::levels);
  EXPECT_EQ(tuning.system.tile, 8);
  EXPECT_EQ(tuning.system.double_buffering, anim::DoubleBuffering::inline_copy);
  EXPECT_EQ(tuning.system.stream, anim::StreamKind::keyframe);
  EXPECT_EQ(tuning.system.palettes, PaletteFormat::packed);
  EXPECT_FALSE(tuning.lod.bone_lod);
  EXPECT_FALSE(tuning.lod.smooth);
  EXPECT_EQ(tuning.mesh_lod, 2);
}

TEST(DemoOptions, SayWhatIsDrawnAndWritten) {
  const DemoOptions options = demo(
      "model.glb --headless=osmesa --draw all --frames 5 --dt 0.5 --size 640x360 --ui=fixed --msaa 4 --shadows off "
      "--screenshot a.png --stats b.json --ui-map c.json --data .");
  EXPECT_THAT(options.models, ElementsAre("model.glb"));
  EXPECT_EQ(options.context, ContextKind::osmesa);
  EXPECT_EQ(options.draw, DrawWhich::all);
  EXPECT_EQ(options.frames, 5);
  EXPECT_TRUE(options.frames_given);
  EXPECT_EQ(options.dt, 0.5);
  EXPECT_EQ(options.width, 640);
  EXPECT_EQ(options.height, 360);
  EXPECT_TRUE(options.ui && options.ui_fixed);
  EXPECT_EQ(options.msaa, 4);
  EXPECT_FALSE(options.tuning.shadows);
  EXPECT_TRUE(options.values_given.has("shadows"));
  EXPECT_THAT((std::vector{options.screenshot, options.stats, options.ui_map, options.data}),
              ElementsAre("a.png", "b.json", "c.json", "."));
}

TEST(DemoOptions, SayWhichValuesAreGivenAndNoOthers) {
  EXPECT_THAT(demo("--agents 5 --error-px 1").values_given.keys, UnorderedElementsAre("agents", "error_px"));
  EXPECT_THAT(demo("--set paused=on,frame_rate=20").values_given.keys, UnorderedElementsAre("paused", "frame_rate"));
  EXPECT_THAT(demo("--quality auto").values_given.keys, ElementsAre("holds_rate"));
  EXPECT_TRUE(demo("--quality low").values_given.has("triangle_budget"));
  EXPECT_FALSE(demo("--error-px 1").values_given.has("triangle_budget"));
}

TEST(DemoOptions, TakeUpToSixteenModelsInOneCrowd) {
  EXPECT_THAT(demo("a.glb --agents 5 b.glb c.glb").models, ElementsAre("a.glb", "b.glb", "c.glb"));
  EXPECT_EQ(demo("1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30").models.size(),
            most_models);
}

TEST(OptionalValue, IsTakenOnlyAfterAnEqualsSign) {
  const DemoOptions before_a_model = demo("--headless model.glb");
  EXPECT_EQ(before_a_model.context, ContextKind::headless_default);
  EXPECT_THAT(before_a_model.models, ElementsAre("model.glb"));
  EXPECT_THAT(demo("--headless egl").models, ElementsAre("egl"));
  EXPECT_EQ(demo("--headless=egl").context, ContextKind::egl);
  EXPECT_EQ(demo("--headless=none").context, ContextKind::none);
  EXPECT_THAT(demo("--headless --draw last --ui fixed").models, ElementsAre("fixed"));
  EXPECT_FALSE(demo("--headless --draw last --ui").ui_fixed);
}

TEST(RequiredValue, IsTakenAfterASpaceOrAnEqualsSign) {
  EXPECT_EQ(demo("--agents 5").tuning.agents, 5);
  EXPECT_EQ(demo("--agents=5").tuning.agents, 5);
}

TEST(LodBudget, IsTheRuleOfWhoeverGivesALimit) {
  EXPECT_EQ(demo("--error-px 0.5").tuning.lod.rule, LodRule::budget);
  EXPECT_EQ(demo("--budget-ms 4").tuning.lod.rule, LodRule::budget);
  EXPECT_EQ(demo("").tuning.lod.rule, LodRule::budget);
}

TEST(LodBudget, HoldsAPixelUnlessOtherLimitsAreGiven) {
  const auto limits = [](const Tuning& tuning) { return std::pair(tuning.error_px, tuning.budget_ms); };
  EXPECT_EQ(limits(demo("").tuning), std::pair(1.0F, 0.0F));
  EXPECT_EQ(limits(demo("--lod budget").tuning), std::pair(1.0F, 0.0F));
  EXPECT_EQ(limits(demo("--error-px 0.5").tuning), std::pair(0.5F, 0.0F));
  EXPECT_EQ(limits(demo("--budget-ms 4").tuning), std::pair(0.0F, 4.0F));
  EXPECT_EQ(limits(demo("--budget-ms 4 --error-px 2").tuning), std::pair(2.0F, 4.0F));
}

TEST(LodOff, TurnsOffAllThatOnlySavesWork) {
  const Tuning tuning = demo("--lod off").tuning;
  EXPECT_EQ(tuning.lod.rule, LodRule::off);
  EXPECT_FALSE(tuning.lod.bone_lod);
  EXPECT_FALSE(tuning.lod.smooth);
  EXPECT_EQ(tuning.mesh_lod, 0);
}

TEST(LodOff, LeavesWhatIsAskedForInWords) {
  const Tuning tuning = demo("--bone-lod on --lod off --mesh-lod 3").tuning;
  EXPECT_TRUE(tuning.lod.bone_lod);
  EXPECT_FALSE(tuning.lod.smooth);
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
  EXPECT_EQ(options.stream, anim::StreamKind::keyframe);
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
  EXPECT_THAT(options.agents, ElementsAre(1000));
  EXPECT_THAT(options.bones, ElementsAre(62));
  EXPECT_THAT(options.clips, ElementsAre(2));
  EXPECT_EQ(options.frames, 60);
  EXPECT_THAT(options.pus, ElementsAre(0));
  EXPECT_EQ(options.tuning.system, Tuning().system);
  EXPECT_THAT(options.schedules, ElementsAre(anim::Schedule::fused));
  EXPECT_THAT(options.streams, ElementsAre(anim::StreamKind::sampled));
  EXPECT_EQ(options.plot + options.trace, "");
  EXPECT_EQ(options.tuning.system.double_buffering, anim::DoubleBuffering::interleaved);
  EXPECT_EQ(options.json, "");
}

TEST(Bench, TakesTheSchedulingOptionsOfTheDemo) {
  const auto options = accepted<BenchOptions>(
      "bench --agents 10000 --bones 30 --clips 5 --pus 2 --schedule levels --stream keyframe --local-store auto --tile "
      "16 "
      "--double-buffer off --palette packed --frames 9 --json -");
  EXPECT_THAT(options.agents, ElementsAre(10000));
  EXPECT_THAT(options.bones, ElementsAre(30));
  EXPECT_THAT(options.clips, ElementsAre(5));
  EXPECT_THAT(options.pus, ElementsAre(2));
  EXPECT_THAT(options.schedules, ElementsAre(anim::Schedule::levels));
  EXPECT_THAT(options.streams, ElementsAre(anim::StreamKind::keyframe));
  EXPECT_EQ(options.tuning.system.tile, 16);
  EXPECT_EQ(options.tuning.system.double_buffering, anim::DoubleBuffering::off);
  EXPECT_EQ(options.tuning.system.palettes, PaletteFormat::packed);
  EXPECT_EQ(options.frames, 9);
  EXPECT_EQ(options.json, "-");
}

TEST(Bench, TakesListsOfWhatATableHas) {
  const auto options = accepted<BenchOptions>(
      "bench --agents 1000,10000 --bones 16,62 --clips 2,24 --pus 1,2 --schedule fused,levels --stream "
      "sampled,keyframe --plot a.svg --trace t.json");
  EXPECT_THAT(options.agents, ElementsAre(1000, 10000));
  EXPECT_THAT(options.bones, ElementsAre(16, 62));
  EXPECT_THAT(options.clips, ElementsAre(2, 24));
  EXPECT_THAT(options.pus, ElementsAre(1, 2));
  EXPECT_THAT(options.schedules, ElementsAre(anim::Schedule::fused, anim::Schedule::levels));
  EXPECT_THAT(options.streams, ElementsAre(anim::StreamKind::sampled, anim::StreamKind::keyframe));
  EXPECT_EQ(options.plot, "a.svg");
  EXPECT_EQ(options.trace, "t.json");
}

TEST(Help, IsThereForEveryCommand) {
  EXPECT_THAT(shown("--help"), HasSubstr("Usage: throng [OPTIONS] [MODEL...]"));
  EXPECT_THAT(shown("-h"), HasSubstr("--headless[=egl|osmesa|none]"));
  EXPECT_THAT(shown("pose --help"), HasSubstr("Usage: throng pose [OPTIONS] MODEL"));
  EXPECT_THAT(shown("pose --help"), HasSubstr("--clip NAME|INDEX (required)"));
  EXPECT_THAT(shown("inspect --help"), HasSubstr("Usage: throng inspect [OPTIONS] MODEL"));
  EXPECT_THAT(shown("lod --help"), HasSubstr("Usage: throng lod [OPTIONS] [MODEL]"));
  EXPECT_THAT(shown("bench --help"), HasSubstr("Usage: throng bench [OPTIONS] [MODEL]"));
  EXPECT_THAT(shown("bake --help"), HasSubstr("Usage: throng bake [OPTIONS] MODEL"));
  EXPECT_THAT(shown("check --help"), HasSubstr("Usage: throng check [OPTIONS] CASES"));
  EXPECT_THAT(shown("compare --help"), HasSubstr("Usage: throng compare [OPTIONS] EXPECTED ACTUAL"));
}

TEST(Help, IsShownBesideWhatWouldBeRefused) {
  EXPECT_THAT(shown("--agents 0 --help"), HasSubstr("Usage: throng"));
  EXPECT_THAT(shown("--help --agent"), HasSubstr("Usage: throng"));
}

TEST(Version, NamesTheProgramAndWhatItHas) {
  EXPECT_THAT(shown("--version"),
              testing::MatchesRegex("throng [0-9]+\\.[0-9]+\\.[0-9]+\n"
                                    "commit: ([0-9a-f]{12}(-dirty)?|unknown)\n"
                                    "SIMD: [A-Z0-9_]+(, [A-Z0-9_]+)*; this machine takes [A-Z0-9_]+\n"
                                    "contexts: window, egl(, osmesa|; osmesa is not installed)\n"
                                    "Mesa: [^\n]+\n"
                                    "ffmpeg: [^\n]+\n"));
}

TEST(Version, IsThereForEveryCommand) { EXPECT_EQ(shown("check --version"), shown("--version")); }

TEST(ValueOfAnOption, MayBeginWithDashes) { EXPECT_EQ(demo("--stats --odd-name.json").stats, "--odd-name.json"); }

}  // namespace
}  // namespace throng::app::options_test
