// People who follow the rows of a recorded crowd, on a stage.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/stage/foot_slips.h"
#include "tests/app/show/stage/tracks_stage.h"

namespace throng::app::track_players_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

/// Six people who come one after the other, walk round in circles of their own, slow down, stop for two seconds, and go
/// on faster.
std::shared_ptr<const Trajectories> some_people() {
  Trajectories all;
  for (int person = 0; person < 6; ++person) {
    PersonTrack track{
        .id = std::to_string(100 + person), .stature = 1.6F + 0.05F * static_cast<float>(person), .rows = {}};
    double way = 0.0;
    for (int row = 0; row < 250; ++row) {
      const double seconds = 0.5 * person + 0.04 * row;
      const double slows = std::clamp((120 - row) / 25.0, 0.0, 1.0),
                   sets_out = std::clamp((row - 170) / 25.0, 0.0, 1.0);
      way += 0.04 * (0.9 * slows + 1.5 * sets_out);
      const double angle = way / (3.0 + person);
      track.rows.push_back({.seconds = seconds,
                            .x = static_cast<float>((3.0 + person) * std::sin(angle)),
                            .z = static_cast<float>((3.0 + person) * std::cos(angle))});
    }
    all.last_seconds = track.rows.back().seconds;
    all.row_count += track.rows.size();
    all.persons.push_back(std::move(track));
  }
  all.rows_a_second = 25.0;
  all.file = "people";
  return std::make_shared<const Trajectories>(std::move(all));
}

class TrackPlayers : public TracksStage {
 protected:
  TrackPlayers() : TracksStage(some_people(), {.x = 0, .y = 20, .z = 25, .yaw = 0, .pitch = -40}, frame) {
    open(tuning(LodRule::off));
  }

  static Tuning tuning(LodRule rule) {
    return {.scene = Scene::tracks,
            .lod = {.rule = rule, .bone_lod = false, .smooth = rule != LodRule::off},
            .system = {.pus = 2}};
  }
  /// Returns the bits of everybody's palette, agent by agent.
  std::vector<std::byte> drawn() const {
    std::vector<std::byte> bytes;
    for (std::uint32_t agent = 0; agent < stage_->crowd().size(); ++agent) {
      const ShownPose& pose = stage_->posed().shown().pose(agent);
      if (!pose.shown()) continue;
      const auto* const palette = reinterpret_cast<const std::byte*>(pages_->palette(pose.to));
      bytes.insert(bytes.end(), palette, palette + 62 * sizeof(anim::PaletteMatrix));
    }
    return bytes;
  }

  /// Returns by how much a number of two drawings differs at most.
  static float farthest(const std::vector<std::byte>& one, const std::vector<std::byte>& other) {
    EXPECT_EQ(one.size(), other.size());
    float most = 0.0F;
    for (std::size_t at = 0; at < std::min(one.size(), other.size()); at += sizeof(float)) {
      float a = 0.0F, b = 0.0F;
      std::memcpy(&a, &one[at], sizeof(a));
      std::memcpy(&b, &other[at], sizeof(b));
      most = std::max(most, std::abs(a - b));
    }
    return most;
  }
};

TEST_F(TrackPlayers, EverybodyIsWhereTheRowsAre) {
  EXPECT_EQ(stage_->crowd().size(), 6U);
  for (const PersonTrack& person : people_->persons) {
    for (std::size_t row = 0; row < person.rows.size(); row += 17) {
      const TrackRow& wanted = person.rows[row];
      go_to(wanted.seconds);
      const auto agent = static_cast<std::size_t>(&person - people_->persons.data());
      EXPECT_LT(glm::distance(stage_->crowd().positions()[agent], glm::vec3(wanted.x, wanted.y, wanted.z)), 1e-3F);
    }
  }
}

TEST_F(TrackPlayers, PeopleAreThereFromTheirFirstRowToTheirLast) {
  const auto there = [&](double seconds) {
    go_to(seconds);
    pass(1, Ticks{});
    return stage_->posed().selection().visible.size();
  };
  EXPECT_EQ(there(0.2), 1U);
  EXPECT_EQ(there(1.2), 3U);
  EXPECT_EQ(there(9.0), 6U);
  EXPECT_EQ(there(12.4), 1U);
}

TEST_F(TrackPlayers, WhoIsTallInTheFileIsTall) {
  EXPECT_NEAR(stage_->crowd().scales()[0] * 1.8F, 1.6F, 0.01F);
  EXPECT_NEAR(stage_->crowd().scales()[5] * 1.8F, 1.85F, 0.01F);
}

TEST_F(TrackPlayers, AMomentIsTheSameHoweverOneCameThere) {
  Tuning without_feet = tuning(LodRule::off);
  without_feet.placed_feet = false;  // feet that stand remember where they came down
  open(without_feet);
  pass(400);
  const double moment = seconds();
  const std::vector<std::byte> played = drawn();
  go_to(1.0);
  pass(3);
  go_to(moment);
  pass(1, Ticks{});
  ASSERT_EQ(drawn().size(), played.size());
  EXPECT_EQ(drawn(), played);
}

TEST_F(TrackPlayers, TheCrowdGoesBackwards) {
  go_to(6.0);
  TrackClock clock = stage_->crowd().tracks()->clock();
  clock.rate = -1.0;
  stage_->set_track_clock(clock);
  pass(60);
  EXPECT_NEAR(seconds(), 5.0, 1e-3);
}

TEST_F(TrackPlayers, FeetDoNotSlip) {
  FootSlips slips(stage_->characters()[0].character->skeleton);
  for (int i = 0; i < 600; ++i) {
    pass(1);
    slips.add_frame(*stage_, *pages_, to_seconds(frame));
  }
  const std::vector<double> all = slips.slips();
  EXPECT_GT(all.size(), 60U);
  EXPECT_LT(slip_at(all, 0.5), 1.0) << "millimetres a step";
  EXPECT_LT(slip_at(all, 0.95), 10.0);
}

TEST_F(TrackPlayers, WithLevelOfDetailThePoseOfALongIntervalIsThatOfItsEnd) {
  open(tuning(LodRule::distance));
  camera_ = camera_at({.x = 0, .y = 90, .z = 120, .yaw = 0, .pitch = -37});
  pass(300);
  EXPECT_GT(stage_->posed().selection().visible[0].interval, 1);
  EXPECT_LT(stage_->system().figures().report().agents_updated, stage_->posed().selection().visible.size());
}

TEST_F(TrackPlayers, NobodyWhoFollowsAFileIsPushedOverOrHeld) {
  const Status pushed = stage_->animated().push_over(0, {1.0F, 0.0F, 0.0F});
  ASSERT_FALSE(pushed);
  EXPECT_EQ(pushed.error().message, "an agent that acts in the cut scene or follows a file cannot be pushed over");
}

TEST_F(TrackPlayers, AJumpLeavesNoFootWhereItWas) {
  pass(400);
  go_to(2.0);
  pass(1, Ticks{});
  const std::vector<std::byte> jumped = drawn();
  open(tuning(LodRule::off));
  go_to(2.0);
  pass(1, Ticks{});
  EXPECT_LT(farthest(drawn(), jumped), 1e-4F) << "as on a stage where nobody was anywhere before";
}

TEST_F(TrackPlayers, APartThatBeginsAnewLeavesNoFootWhereItWas) {
  TrackClock part = with_part(stage_->crowd().tracks()->clock(), 2.0, 6.0);
  part.repeats = true;
  part.seconds = 5.5;
  stage_->set_track_clock(part);
  for (int i = 0; i < 120 && seconds() >= 5.5; ++i) pass(1);
  ASSERT_LT(seconds(), 2.1);
  const double moment = seconds();
  const std::vector<std::byte> repeated = drawn();
  open(tuning(LodRule::off));
  go_to(moment);
  pass(1, Ticks{});
  EXPECT_LT(farthest(drawn(), repeated), 1e-4F);
}

TEST_F(TrackPlayers, TheClockStaysAsItIsInAnotherSceneAndWithOtherClips) {
  TrackClock asked = with_part(stage_->crowd().tracks()->clock(), 2.0, 6.0);
  asked.rate = -0.5;
  asked.repeats = true;
  stage_->set_track_clock(asked);
  Tuning other = stage_->tuning();
  other.scene = Scene::grid;
  ASSERT_TRUE(stage_->apply(other));
  pass(5);
  other.scene = Scene::tracks;
  ASSERT_TRUE(stage_->apply(other));
  EXPECT_EQ(stage_->crowd().tracks()->clock(), asked);
  stage_->set_roles(0, stage_->characters()[0].roles.clips);
  EXPECT_EQ(stage_->crowd().tracks()->clock(), asked);
}

TEST_F(TrackPlayers, TheSceneNeedsAFile) {
  std::vector<CharacterSource> characters;
  characters.push_back(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin"));
  const auto made = Stage::create(std::move(characters), tuning(LodRule::off), *pages_);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "scene tracks: no file of trajectories is open; start with --trajectories FILE");
}

TEST_F(TrackPlayers, AnotherSceneAndBackBeginsTheCrowdAnew) {
  pass(100);
  Tuning plaza = stage_->tuning();
  plaza.scene = Scene::plaza;
  plaza.agents = 20;
  ASSERT_TRUE(stage_->apply(plaza));
  pass(5);
  EXPECT_EQ(stage_->crowd().size(), 20U);
  Tuning back = stage_->tuning();
  back.scene = Scene::tracks;
  ASSERT_TRUE(stage_->apply(back));
  pass(5);
  EXPECT_EQ(stage_->crowd().size(), 6U);
}

}  // namespace
}  // namespace throng::app::track_players_test
