// One character alone, at the times of its clips that a person asks for.

#include "app/show/viewer/viewer.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/stage/stage.h"

namespace throng::app::viewer_test {
namespace {

constexpr Ticks tenth = ticks_per_second / 10;
constexpr const char* mannequin = THRONG_SOURCE_DIR "/assets/mannequin.glb";
constexpr const char* pillar = THRONG_SOURCE_DIR "/tests/data/features/plain.glb";

class ViewedAlone : public testing::Test {
 protected:
  ViewedAlone() { open(mannequin); }

  void open(const char* file, const ViewRequest& request = {}) {
    auto character = load_character(file, file);
    ASSERT_TRUE(character) << character.error().message;
    view(std::move(*character), request);
  }
  void view(CharacterSource&& character, const ViewRequest& request) {
    viewer_.reset();
    std::vector<CharacterSource> characters;
    characters.push_back(std::move(character));
    auto stage =
        Stage::create(std::move(characters), {.scene = Scene::grid, .agents = 3, .system = {.pus = 1}}, pages_);
    ASSERT_TRUE(stage);
    stage_ = std::move(*stage);
    auto made = Viewer::create(*stage_, request, {{100, 0.0F}, {10, 0.01F}});
    ASSERT_TRUE(made) << made.error().message;
    viewer_ = std::move(*made);
  }
  void choose(const std::function<void(ViewerSettings&)>& change) {
    ViewerSettings settings = viewer_->settings();
    change(settings);
    viewer_->choose(settings);
    viewer_->advance({});
  }
  std::vector<float> palette() const {
    const auto entries = viewer_->viewed().palette();
    const float* const first = &entries.front().rows[0][0];
    return {first, first + entries.size() * 12};
  }

  HeapPageSource pages_{std::size_t{1} << 20U};
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<Viewer> viewer_;
};

float farthest(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

TEST_F(ViewedAlone, ListsEachClipWithItsLength) {
  const ViewerReport report = viewer_->report();
  const CharacterSource& source = stage_->people().front();
  ASSERT_EQ(report.clips.size(), source.clip_names.size());
  for (std::size_t i = 0; i < report.clips.size(); ++i) {
    EXPECT_EQ(report.clips[i].name, source.clip_names[i]);
    EXPECT_FLOAT_EQ(report.clips[i].seconds, static_cast<float>(to_seconds(source.character->clips[i].duration)));
  }
  EXPECT_EQ(report.settings.clip, source.roles.clip(Role::stand)) << "who is asked for nothing stands";
}

TEST_F(ViewedAlone, PosesAnyTimeAsTheDefinitionHasIt) {
  const CharacterSource& source = stage_->people().front();
  choose([&](ViewerSettings& settings) { settings.clip = source.roles.clip(Role::walk); });
  viewer_->scrub(0.5F);
  viewer_->advance(tenth);
  EXPECT_FLOAT_EQ(viewer_->report().seconds, 0.5F) << "it waits where it was put";
  const auto before = palette();
  viewer_->scrub(0.25F);
  viewer_->advance({});
  EXPECT_GT(farthest(palette(), before), 0.01F);
  viewer_->scrub(0.5F);
  viewer_->advance({});
  EXPECT_EQ(palette(), before) << "the same time is the same pose, to the bit";
}

TEST_F(ViewedAlone, PlaysAtItsSpeedAndLoopsOrStops) {
  const double length = static_cast<double>(viewer_->report().length);
  viewer_->advance(tenth);
  EXPECT_NEAR(viewer_->report().seconds, 0.1, 1e-4);
  choose([](ViewerSettings& settings) { settings.speed = 2.0F; });
  viewer_->advance(tenth);
  EXPECT_NEAR(viewer_->report().seconds, 0.3, 1e-4);
  viewer_->advance(to_ticks(length / 2));
  EXPECT_NEAR(viewer_->report().seconds, 0.3, 1e-3) << "it has come round";
  choose([](ViewerSettings& settings) { settings.loops = false; });
  viewer_->advance(to_ticks(length));
  EXPECT_NEAR(viewer_->report().seconds, length, 1e-6);
  EXPECT_FALSE(viewer_->settings().plays) << "it has ended";
  choose([](ViewerSettings& settings) { settings.plays = true; });
  EXPECT_EQ(viewer_->report().seconds, 0.0F) << "and plays once more";
}

TEST_F(ViewedAlone, BlendsTwoClipsInStep) {
  const CharacterRoles& roles = stage_->people().front().roles;
  const int walk = roles.clip(Role::walk), run = roles.clip(Role::run);
  choose([&](ViewerSettings& settings) { settings.clip = walk; });
  const float of_walk = viewer_->report().length;
  choose([&](ViewerSettings& settings) { settings.clip = run; });
  const float of_run = viewer_->report().length;
  const auto at = [&](int first, int second, float weight) {
    choose([&](ViewerSettings& settings) {
      settings.clip = first;
      settings.blended = second;
      settings.weight = weight;
    });
    viewer_->scrub(0.5F * viewer_->report().length);
    viewer_->advance({});
    return palette();
  };
  const auto all_walk = at(walk, no_clip, 0.5F), all_run = at(run, no_clip, 0.5F);
  EXPECT_LT(farthest(at(walk, run, 0.0F), all_walk), 1e-5F);
  EXPECT_LT(farthest(at(walk, run, 1.0F), all_run), 1e-5F);
  const auto half = at(walk, run, 0.5F);
  EXPECT_GT(farthest(half, all_walk), 0.01F);
  EXPECT_GT(farthest(half, all_run), 0.01F);
  EXPECT_NEAR(viewer_->report().length, (of_walk + of_run) / 2, 1e-5F);
}

TEST_F(ViewedAlone, ShowsTheBindPoseInWhichEachJointIsWhereItsSkinHasIt) {
  choose([](ViewerSettings& settings) { settings.bind_pose = true; });
  const anim::Skeleton& skeleton = viewer_->viewed().character().skeleton;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const auto joint = viewer_->viewed().joint(bone);
    ASSERT_TRUE(joint);
    EXPECT_LT(glm::distance(*joint, glm::vec3(anim::joint_place(skeleton, bone).position)), 1e-5F) << bone;
  }
}

TEST_F(ViewedAlone, KeepsFewerBonesAtACoarserLevel) {
  const auto all = viewer_->viewed().palette().size();
  const auto last = static_cast<int>(viewer_->report().level_bones.size()) - 1;
  choose([&](ViewerSettings& settings) { settings.bone_level = last; });
  EXPECT_LT(viewer_->viewed().palette().size(), all);
  choose([](ViewerSettings& settings) { settings.bone_level = 100; });
  EXPECT_EQ(viewer_->settings().bone_level, last) << "there is no coarser one";
  choose([](ViewerSettings& settings) { settings.mesh_lod = 100; });
  EXPECT_EQ(viewer_->settings().mesh_lod, 1);
}

TEST_F(ViewedAlone, OfAModelWithoutClipsShowsItsRestPose) {
  open(pillar);
  EXPECT_EQ(viewer_->report().clips.size(), 1U);
  viewer_->advance(tenth);
  EXPECT_FALSE(viewer_->viewed().palette().empty());
}

TEST_F(ViewedAlone, IsDrawnEquallyLargeWhateverItsSize) {
  for (const double scale : {0.03, 1.0, 44.0}) {
    auto character = load_character(mannequin, "it", nullptr, {.placement = {.scale = scale}});
    ASSERT_TRUE(character) << character.error().message;
    view(std::move(*character), {});
    const ViewerReport report = viewer_->report();
    EXPECT_NEAR(report.drawn_scale * report.height, 1.435F, 1e-3F) << scale;
    const render::Camera camera = viewer_->turntable().camera(16.0F / 9.0F, 0.0F);
    const float away = glm::length(camera.position);
    EXPECT_GT(away - 1.0F, render::Camera::near_distance) << "nothing is cut off";
    EXPECT_LT(away, 5.0F);
  }
}

TEST_F(ViewedAlone, IsOneInstanceOfItsCharacterInASlotOfTheStage) {
  const std::size_t before = stage_->posed().shown().slots().slots_in_use();
  const render::CrowdFrame frame = viewer_->frame(render::view_of({}, 1.0F));
  ASSERT_EQ(frame.instances.size(), 1U);
  ASSERT_EQ(frame.batches.size(), 1U);
  EXPECT_EQ(frame.batches[0].count, 1U);
  viewer_.reset();
  stage_->pose({}, 64, 64, tenth, stage_->posed().frame());
  EXPECT_LE(stage_->posed().shown().slots().slots_in_use(), before + stage_->crowd().size()) << "it gave its slot back";
}

TEST_F(ViewedAlone, RefusesWhatThereIsNot) {
  EXPECT_FALSE(Viewer::create(*stage_, {.character = 1}, {})) << "the balloon is no person";
  EXPECT_FALSE(Viewer::create(*stage_, {.agent = 3}, {}));
  EXPECT_FALSE(Viewer::create(*stage_, {.clip = 1000}, {}));
}

}  // namespace
}  // namespace throng::app::viewer_test
