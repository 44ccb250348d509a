// What level of detail costs the eye, as the stage measures it.

#include "engine/crowd/error_meter.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/lod/tuned_view.h"
#include "app/show/stage/stage.h"

namespace throng::app::error_meter_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr int width = 1280, height = 720;

std::vector<CharacterSource> mannequin() {
  std::vector<CharacterSource> characters;
  characters.push_back(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin"));
  return characters;
}

class MeasuredStage : public testing::Test {
 protected:
  void pass(const Tuning& tuning, int frames) {
    auto made = Stage::create(mannequin(), tuning, pages_);
    ASSERT_TRUE(made);
    stage_ = std::move(*made);
    go_on(frames);
  }
  void pass_on(const Tuning& tuning, int frames) {
    ASSERT_TRUE(stage_->apply(tuning));
    go_on(frames);
  }
  void go_on(int frames) {
    for (int i = 0; i < frames; ++i) {
      stage_->move(frame);
      stage_->pose(camera_, width, height, frame, stage_->posed().frame());
    }
  }
  static Tuning measured() {
    Tuning tuning;
    tuning.agents = 120;
    tuning.lod.rule = LodRule::distance;
    tuning.error_sample = ErrorSampling::all;
    tuning.system.pus = 2;
    return tuning;
  }

  HeapPageSource pages_{std::size_t{4} << 20U};
  std::unique_ptr<Stage> stage_;
  render::Camera camera_ = camera_at({.x = 0, .y = 6, .z = 14, .yaw = 0, .pitch = -20});
};

TEST_F(MeasuredStage, SeesNoErrorWithoutLevelOfDetail) {
  Tuning tuning = measured();
  tuning.lod.rule = LodRule::off;
  tuning.lod.bone_lod = tuning.lod.smooth = false;
  pass(tuning, 90);
  EXPECT_GT(stage_->posed().error_meter().figures().samples, 1000U);
  EXPECT_EQ(stage_->posed().error_meter().figures().max, 0.0F);
  EXPECT_EQ(stage_->posed().error_meter().figures().pop_max, 0.0F);
}

TEST_F(MeasuredStage, SeesMoreTheLongerUpdatesAreSkipped) {
  Tuning tuning = measured();
  tuning.lod.full_rate_distance = 0.1F;
  tuning.lod.interval_growth = 0.1F;
  tuning.lod.bone_lod = tuning.placed_feet = false;
  float before = 0.0F;
  for (const int interval : {2, 4, 8}) {
    tuning.lod.largest_interval = interval;
    pass(tuning, 90);
    EXPECT_GT(stage_->posed().error_meter().figures().p99, 1.5F * before) << interval;
    before = stage_->posed().error_meter().figures().p99;
  }
}

TEST_F(MeasuredStage, SeesMoreWherePosesAreHeldThanWhereTheyBlend) {
  Tuning tuning = measured();
  tuning.lod.full_rate_distance = tuning.lod.interval_growth = 1.0F;
  tuning.lod.bone_lod = false;
  pass(tuning, 90);
  const anim::ErrorFigures smooth = stage_->posed().error_meter().figures();
  tuning.lod.smooth = false;
  pass(tuning, 90);
  EXPECT_GT(stage_->posed().error_meter().figures().p99, 3.0F * smooth.p99);
  EXPECT_GT(stage_->posed().error_meter().figures().pop_max, 3.0F * smooth.pop_max);
}

TEST_F(MeasuredStage, SeesBonesThatAreLeftOut) {
  Tuning tuning = measured();
  tuning.lod.full_rate_distance = 1000.0F;
  tuning.placed_feet = false;
  std::ranges::fill(tuning.lod.level_distances, 0.1F);
  pass(tuning, 30);
  EXPECT_GT(stage_->posed().error_meter().figures().p50, 0.5F);
}

TEST_F(MeasuredStage, PosesAlikeWhoeverIsMeasured) {
  Tuning tuning = measured();
  std::vector<std::uint64_t> hashes;
  for (const ErrorSampling sampling : {ErrorSampling::off, ErrorSampling::some, ErrorSampling::all}) {
    tuning.error_sample = sampling;
    pass(tuning, 120);
    hashes.push_back(stage_->system().figures().pose_hash());
  }
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
}

TEST_F(MeasuredStage, MeasuresNobodyWhereItIsOff) {
  Tuning tuning = measured();
  tuning.error_sample = ErrorSampling::off;
  pass(tuning, 30);
  EXPECT_EQ(stage_->posed().error_meter().figures().samples, 0U);
}

TEST_F(MeasuredStage, MeasuresEverybodyWhereErrorsAreColours) {
  Tuning tuning = measured();
  tuning.error_sample = ErrorSampling::some;
  tuning.debug_view = DebugView::error;
  pass(tuning, 60);
  for (const anim::VisibleAgent& agent : stage_->posed().selection().visible) {
    EXPECT_GE(stage_->posed().error_meter().error_of(agent.agent), 0.0F) << agent.agent;
  }
}

TEST_F(MeasuredStage, TakesFewOfManyForAsLittleAsTheyCost) {
  Tuning tuning = measured();
  tuning.agents = 600;
  tuning.error_sample = ErrorSampling::some;
  pass(tuning, 120);
  EXPECT_GT(stage_->posed().error_meter().figures().samples, 40U);
  EXPECT_LT(stage_->posed().error_meter().figures().samples, 60U * WatchedAgents::few);
  EXPECT_GT(stage_->posed().error_meter().figures().pop_max, 0.0F);
}

TEST_F(MeasuredStage, KnowsItsFiguresWithinASecondForFewAsForMany) {
  Tuning tuning;
  tuning.system.pus = 2;
  for (const int agents : {60, 1000}) {
    tuning.agents = agents;
    pass(tuning, 60);
    EXPECT_TRUE(stage_->posed().error_meter().figures().p99_is_known()) << agents;
    EXPECT_TRUE(stage_->posed().error_meter().intervals().p99.high) << agents;
    EXPECT_LE(stage_->posed().error_meter().intervals().p99.low, stage_->posed().error_meter().figures().p99) << agents;
  }
}

TEST_F(MeasuredStage, MeasuresASingleAgentToo) {
  Tuning tuning;
  tuning.agents = 1;
  tuning.system.pus = 1;
  camera_ = camera_at({.x = 0, .y = 30, .z = 60, .yaw = 0, .pitch = -25});
  pass(tuning, 60);
  ASSERT_EQ(stage_->posed().selection().visible.size(), 1U);
  EXPECT_GT(stage_->posed().error_meter().figures().samples, 30U);
}

// One of sixty is more than the hundredth part: what it does next is not known from what it did.
TEST_F(MeasuredStage, TellsTheErrorLimitNothingOfFewAgents) {
  Tuning tuning;
  tuning.system.pus = 2;
  for (const int agents : {60, 1000}) {
    tuning.agents = agents;
    pass(tuning, 90);
    ASSERT_EQ(stage_->posed().selection().visible.size() >= 100, agents == 1000);
    EXPECT_EQ(stage_->posed().level_of_detail().figures().error_held.has_value(), agents == 1000);
  }
}

// Poses that are shown past their time would be off by so much that the limit left nothing to skip.
TEST_F(MeasuredStage, UsesItsLimitWhereFramesDifferInLengthToo) {
  Tuning tuning = measured();
  tuning.lod.rule = LodRule::budget;
  tuning.mesh_lod = 0;
  tuning.error_px = 3.0F;
  pass(tuning, 0);
  constexpr std::array<int, 7> parts{10, 4, 16, 10, 7, 14, 9};  // tenths
  for (int i = 0; i < 200; ++i) {
    const Ticks step = frame * parts[static_cast<std::size_t>(i) % parts.size()] / 10;
    stage_->move(step);
    stage_->pose(camera_, width, height, step, stage_->posed().frame());
  }
  EXPECT_LE(stage_->posed().error_meter().figures().p99, tuning.error_px);
  EXPECT_GE(stage_->posed().level_of_detail().figures().tolerance_px, tuning.error_px / 2);
}

TEST_F(MeasuredStage, ForgetsTheErrorsOfOtherValues) {
  Tuning tuning = measured();
  tuning.inspection.forced_interval = 16;
  pass(tuning, 60);
  const anim::ErrorFigures before = stage_->posed().error_meter().figures();
  tuning.time_scale = 0.5F;
  pass_on(tuning, 1);
  EXPECT_GT(stage_->posed().error_meter().figures().samples, before.samples / 2) << "the clock decides over nothing";
  tuning.inspection.forced_interval = 1;
  pass_on(tuning, 20);
  EXPECT_LT(stage_->posed().error_meter().figures().samples, before.samples / 2);
  EXPECT_GT(stage_->posed().error_meter().since_start().samples, before.samples);
}

TEST_F(MeasuredStage, RemembersHowTheErrorWent) {
  Tuning tuning = measured();
  pass(tuning, 40);
  const ErrorHistory& history = stage_->posed().error_meter().history();
  EXPECT_EQ(history.p99().size(), 20U);
  EXPECT_EQ(history.p99().back(), stage_->posed().error_meter().figures().p99);
  EXPECT_EQ(std::ranges::max(history.pop()), stage_->posed().error_meter().figures().pop_max);
}

TEST(ErrorHistory, KeepsTheNewestValuesAndTheLargestPopOfTwoFrames) {
  ErrorHistory history;
  history.add({.p99 = 1, .pop = 5});
  history.add({.p99 = 2, .pop = 3});
  EXPECT_EQ(history.p99().size(), 1U);
  EXPECT_EQ(history.p99().back(), 2);
  EXPECT_EQ(history.pop().back(), 5);
  for (std::size_t i = 0; i < 3 * ErrorHistory::most_values; ++i) history.add({.p99 = 3, .pop = 0});
  EXPECT_EQ(history.p99().size(), ErrorHistory::most_values);
  EXPECT_EQ(history.p99().front(), 3);
}

/// One agent of which the meter is shown a palette that is wrong.
class DisplacedBone : public testing::Test {
 protected:
  DisplacedBone() : system_(std::move(*anim::AnimationSystem::create(characters_.front().character, {}))) {
    system_->set_agent_count(1);
    system_->agent(0).play({.clip = 0});
    shown_.reset(1, 0);
    meter_.reset(1);
  }

  /// On screen, of a shin that the slot has `off_by` from where it belongs.
  float error_of(const glm::vec3& off_by) {
    const anim::VisibleAgent visible{.agent = 0, .pixels_tall = 100.0F, .interval = 1, .bone_level = 0};
    meter_.begin_frame(ErrorSampling::all, {&visible, 1}, shown_);
    system_->advance(frame);
    std::byte* const slot = shown_.show({.agent = 0, .level = 0, .entries = entries(), .time = 0}, 0, 0);
    const PoseRequest update{.agent = {0}, .palette = meter_.destination(0, shown_.pose(0), entries(), slot)};
    system_->update({&update, 1});
    auto& entry = reinterpret_cast<anim::PaletteMatrix*>(update.palette)[shin()];
    for (int axis = 0; axis < 3; ++axis) entry.rows[axis][3] += off_by[axis];
    const auto mesh = static_cast<std::uint8_t>(mesh_lods_.choose(rules_.meshes, 0, visible.pixels_tall));
    const PlacedAgents agents = placed_agents(crowd_);
    const render::CameraView view = render::view_of(camera_, static_cast<float>(width) / height);
    meter_.end_frame(*system_, {.rules = rules_,
                                .agents = agents,
                                .visible = {&visible, 1},
                                .mesh_lods = mesh_lods_,
                                .mesh_of_visible = {&mesh, 1},
                                .shown = shown_,
                                .view = view.view,
                                .projection = view.projection,
                                .size = {width, height},
                                .now = 0,
                                .number = ++frame_});
    return meter_.error_of(0);
  }
  std::uint32_t entries() const {
    return static_cast<std::uint32_t>(characters_.front().model.skeleton.palette_count());
  }
  std::size_t shin() const {
    const auto& bones = characters_.front().model.skeleton.bones;
    return static_cast<std::size_t>(std::ranges::find(bones, "shin.L", &anim::Bone::name) - bones.begin());
  }
  float pixels(float metres) const {
    const glm::vec3 knee = crowd_.positions()[0] + glm::vec3(0.0F, 0.3F, 0.0F);
    const float depth = glm::dot(knee - camera_.position, render::forward(camera_));
    return render::pixels_tall(camera_, height, metres * crowd_.scales()[0], depth);
  }

  std::vector<CharacterSource> characters_ = mannequin();
  std::unique_ptr<anim::AnimationSystem> system_;
  HeapPageSource pages_{std::size_t{1} << 20U};
  PaletteSlots slots_{pages_, {anim::palette_stride(entries(), PaletteFormat::matrices)}};
  ShownPoses shown_{slots_};
  ErrorMeter meter_{std::vector{viewed_character(characters_.front())}};
  ViewRules rules_;
  MeshLods mesh_lods_{characters_.size()};
  Crowd crowd_{Scene::grid, 1, 1, characters_.front().roles};
  render::Camera camera_{.position = crowd_.positions()[0] + glm::vec3(0.0F, 0.5F, 8.0F)};
  std::uint64_t frame_ = 0;
};

TEST_F(DisplacedBone, IsOffByAsManyPixelsAsTheDistanceCovers) {
  EXPECT_EQ(error_of({}), 0.0F);
  for (const float metres : {0.01F, 0.05F, 0.2F}) {
    EXPECT_NEAR(error_of({0.0F, metres, 0.0F}), pixels(metres), 0.05F * pixels(metres)) << metres;
  }
}

// Half of the limit of one pixel is the mesh's: 100 pixels tall, it may be off by 0.005 of the height.
TEST_F(DisplacedBone, AddsTheErrorOfTheMeshThatItIsDrawnWith) {
  mesh_lods_.set(0, {{}, {0.004F, 0.004F}, {0.02F, 0.02F}}, {});
  EXPECT_FLOAT_EQ(error_of({}), 0.4F);
  EXPECT_EQ(meter_.pose_figures().max, 0.0F);
  rules_.meshes.lod = 2;
  EXPECT_FLOAT_EQ(error_of({}), 2.0F);
  EXPECT_FLOAT_EQ(meter_.figures().max, 2.0F);
}

TEST_F(DisplacedBone, PopsByAsMuchAsItComesAndGoes) {
  error_of({});
  error_of({0.0F, 0.1F, 0.0F});
  EXPECT_NEAR(meter_.figures().pop_max, pixels(0.1F), 0.05F * pixels(0.1F));
  error_of({0.0F, -0.1F, 0.0F});
  EXPECT_NEAR(meter_.figures().pop_max, pixels(0.2F), 0.05F * pixels(0.2F));
}

}  // namespace
}  // namespace throng::app::error_meter_test
