// What level of detail is measured against.

#include <cstring>

#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/every_kind.h"

namespace throng::anim::exact_poses_test {
namespace {

constexpr Ticks fade = 20 * frame_ticks;

std::size_t entries() { return static_cast<std::size_t>(test_character()->skeleton.palette_count()); }

class Palette {
 public:
  Palette() : bytes_(allocate_aligned((entries() + 3) / 4 * 4 * sizeof(PaletteMatrix))) {}
  PaletteMatrix* get() const { return reinterpret_cast<PaletteMatrix*>(bytes_.get()); }
  bool is(const PaletteMatrix* other) const {
    return std::memcmp(get(), other, entries() * sizeof(PaletteMatrix)) == 0;
  }

 private:
  AlignedBytes bytes_;
};

/// An agent that is updated now and then, ahead of the clock and with few bones, beside one that is updated each frame.
class Skipped : public testing::TestWithParam<SystemOptions> {
 protected:
  static constexpr int interval = 5;

  void ask_both(const PlayRequest& request) {
    skipped_->agent(0).play(request);
    each_frame_->agent(0).play(request);
  }
  void pass(int frames, Ticks look_ahead = interval * frame_ticks) {
    const auto level = static_cast<std::uint8_t>(test_character()->skeleton.level_bone_counts.size() - 1);
    for (int i = 0; i < frames; ++i, ++frame_) {
      each_frame_.step();
      skipped_->advance(frame_ticks);
      const PoseRequest update{.agent = {0}, .level = level, .look_ahead = look_ahead};
      if (frame_ % interval == 0) skipped_->update({&update, 1});
      const ExactPose exact{.agent = {0}, .palette = exact_.get()};
      skipped_->pose_exactly({&exact, 1});
      EXPECT_TRUE(exact_.is(each_frame_.palette())) << "frame " << frame_;
    }
  }

  CrowdRig skipped_{GetParam()};
  CrowdRig each_frame_{GetParam()};
  Palette exact_;
  int frame_ = 0;
};

TEST_P(Skipped, IsExactlyWhereItWouldBeIfItHadBeenUpdatedEachFrame) {
  ask_both({.clip = 0});
  pass(200);
}

TEST_P(Skipped, IsExactlyWhereItWouldBeWithoutLookingAhead) {
  ask_both({.clip = 0});
  pass(40, Ticks{});
}

TEST_P(Skipped, IsExactlyWhereItWouldBeWhileItFades) {
  ask_both({.clip = 0});
  pass(interval);
  ask_both({.clip = 1, .fade = fade});
  pass(40);
}

TEST_P(Skipped, IsWoundBackByAnUpdateBeforeTheTimeWhereItStands) {
  ask_both({.clip = 0});
  pass(interval + 2);
  ask_both({.clip = 1, .fade = fade});
  ASSERT_TRUE(skipped_->agent(0).can_wind_back());
  each_frame_.step();
  skipped_->advance(frame_ticks);
  const PoseRequest update{.agent = {0}, .palette = PaletteDestination(exact_.get()).memory()};
  skipped_->update({&update, 1});
  EXPECT_TRUE(exact_.is(each_frame_.palette()));
}

TEST_P(Skipped, SaysWhenAFadeThatWasInterruptedCannotBeWoundBack) {
  ask_both({.clip = 0});
  pass(interval);
  ask_both({.clip = 1, .fade = fade});
  pass(interval + 1);
  ask_both({.clip = 2, .fade = fade});
  int unknown = 0;
  for (int i = 0; i < 3 * interval; ++i) {
    skipped_->advance(frame_ticks);
    const PoseRequest update{.agent = {0}, .look_ahead = interval * frame_ticks};
    if (i % interval == 0) skipped_->update({&update, 1});
    unknown += skipped_->agent(0).can_pose_exactly() ? 0 : 1;
  }
  EXPECT_EQ(unknown, 2 * interval) << "until the clock is where the offset was captured, at the second update";
  EXPECT_TRUE(skipped_->agent(0).can_pose_exactly());
}

INSTANTIATE_TEST_SUITE_P(Of, Skipped,
                         testing::Values(SystemOptions{}, SystemOptions{.pus = 2, .schedule = Schedule::levels},
                                         SystemOptions{.stream = StreamKind::keyframe}));

// Fades that are interrupted, layers, masks, post processes with memories, rag-dolls, shared sources.
TEST(PoseExactly, ChangesNothingInACrowdOfEveryKind) {
  EveryKind looked_at, left_alone;
  Palette palette;
  for (int frame = 0; frame < 60; ++frame) {
    looked_at.step(1);
    left_alone.step(1);
    for (std::uint32_t agent = 0; agent < EveryKind::agents; ++agent) {
      const ExactPose exact{.agent = {agent}, .palette = palette.get()};
      looked_at->pose_exactly({&exact, 1});
    }
  }
  EXPECT_EQ(looked_at->figures().pose_hash(), left_alone->figures().pose_hash());
}

TEST(PoseExactly, GivesEachOfManyAgentsItsOwnPalette) {
  constexpr std::uint32_t agents = 40;
  CrowdRig crowd({.pus = 3}, agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    crowd->agent(agent).play({.clip = static_cast<int>(agent % 5), .start = to_ticks(0.01 * agent)});
  }
  crowd.step();
  std::vector<Palette> palettes(agents);
  std::vector<ExactPose> exact;
  for (std::uint32_t agent = 0; agent < agents; ++agent)
    exact.push_back({.agent = {agent}, .palette = palettes[agent].get()});
  crowd->pose_exactly(exact);
  for (std::uint32_t agent = 0; agent < agents; ++agent) EXPECT_TRUE(palettes[agent].is(crowd.palette(agent))) << agent;
}

}  // namespace
}  // namespace throng::anim::exact_poses_test
