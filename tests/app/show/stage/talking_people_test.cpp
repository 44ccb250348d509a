// People of a recorded crowd who stand together turn their heads to each other, and not their feet.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "engine/anim/rig/rig_map.h"
#include "tests/app/show/stage/posed_feet.h"
#include "tests/app/show/stage/tracks_stage.h"

namespace throng::app::talking_people_test {
namespace {

/// Two who stand side by side, the first to the right of the second, and one who stands alone; all look ahead.
std::shared_ptr<const Trajectories> some_people() {
  Trajectories all;
  for (const float x : {0.0F, 1.0F, 6.0F}) {
    PersonTrack track{.id = std::to_string(all.persons.size()), .rows = {}};
    for (int row = 0; row <= 300; ++row) track.rows.push_back({.seconds = 0.1 * row, .x = x, .heading = 0.0F});
    all.row_count += track.rows.size();
    all.persons.push_back(std::move(track));
  }
  all.rows_a_second = 10.0;
  all.last_seconds = 30.0;
  all.file = "people";
  return std::make_shared<const Trajectories>(std::move(all));
}

class TalkingPeople : public TracksStage {
 protected:
  TalkingPeople()
      : TracksStage(some_people(), {.x = 2, .y = 2, .z = 6, .yaw = 0, .pitch = -10}, ticks_per_second / 30) {
    open({.scene = Scene::tracks, .lod = {.rule = LodRule::off, .smooth = true}, .system = {.pus = 1}});
    const anim::Skeleton& skeleton = stage_->people().front().character->skeleton;
    const int head = anim::find_rig(skeleton).at(anim::BodyRole::head);
    head_entry_ = static_cast<std::size_t>(anim::joint_place(skeleton, head).entry);
    feet_ = std::make_unique<PosedFeet>(skeleton);
  }

  /// Poses everybody as they are at a time.
  void look_at(double seconds) {
    go_to(seconds);
    pass(1, Ticks{});
  }
  /// Returns the radians by which a head is turned to the left.
  double turned(std::uint32_t agent) const {
    const anim::PaletteMatrix& matrix = pages_->palette(stage_->posed().shown().pose(agent).to)[head_entry_];
    return std::atan2(static_cast<double>(matrix.rows[0][2]), static_cast<double>(matrix.rows[2][2]));
  }
  TalkMoment talk(std::uint32_t agent) const { return stage_->crowd().tracks()->people().talk(agent, seconds()); }

  std::size_t head_entry_ = 0;
  std::unique_ptr<PosedFeet> feet_;
};

TEST_F(TalkingPeople, TurnTheirHeadsToEachOther) {
  int looked = 0;
  for (int i = 0; i < 800; ++i) {
    pass(1);
    if (talk(0).looks < 0.99F) continue;
    ++looked;
    EXPECT_GT(turned(0), 0.8) << seconds();
    EXPECT_LT(turned(1), -0.8) << seconds();
  }
  EXPECT_GT(looked, 300);
  EXPECT_EQ(talk(2).looks, 0.0F);
}

TEST_F(TalkingPeople, DoTheSameHoweverOneCameToAMoment) {
  int compared = 0;
  for (int i = 0; i < 600; ++i) {
    pass(1);
    if (i % 20 != 0 || talk(0).looks == 0.0F) continue;
    const double moment = seconds(), played = turned(0);
    look_at(1.0);
    look_at(29.0);
    look_at(moment);
    EXPECT_NEAR(turned(0), played, 1e-3) << moment;
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST_F(TalkingPeople, KeepTheirFeetWhereTheyStand) {
  pass(150);
  const auto began = feet_->ball(*stage_, *pages_, 0, 0);
  ASSERT_TRUE(began);
  double farthest = 0.0;
  for (int i = 0; i < 500; ++i) {
    pass(1);
    const auto ball = feet_->ball(*stage_, *pages_, 0, 0);
    farthest = std::max(farthest, std::hypot(ball->x - began->x, ball->z - began->z));
  }
  EXPECT_LT(farthest, 2e-3);
}

}  // namespace
}  // namespace throng::app::talking_people_test
