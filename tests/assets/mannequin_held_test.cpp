#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets/mannequin/held.h"
#include "tests/assets/character_file.h"

namespace throng::test::mannequin_held_test {
namespace {

using glm::dvec3;

/// Returns where something of a hand is at a time of a clip; `at_rest` is from the wrist of the left hand at rest.
dvec3 in_hand_at(const Playback& clip, double time, const std::string& joint, dvec3 at_rest) {
  const PosedJoint hand = clip.pose(time)[clip.joint(joint)];
  if (joint.ends_with(".R")) at_rest.x = -at_rest.x;
  return hand.position + hand.rotation * at_rest;
}

const CharacterFile& file() {
  static const CharacterFile committed = CharacterFile::committed();
  return committed;
}

TEST(MannequinStick, StandsOnTheGroundFromTheLeftFootsStrikeUntilItIsBehind) {
  const Playback clip(file(), "stick");
  const dvec3 tip = mannequin::handle_in_hand() + mannequin::left_arm().along * mannequin::stick_length;
  const double strike = 0.75;  // of the left foot
  const dvec3 planted = in_hand_at(clip, strike, "hand.R", tip);
  const double way = clip.pose(1.0)[0].position.z;
  for (double since = 0; since <= 0.55; since += 1.0 / 120) {
    const double time = std::fmod(strike + since, 1.0);
    dvec3 now = in_hand_at(clip, time, "hand.R", tip);
    if (time < strike) now.z += way;
    EXPECT_LT(std::abs(now.y), 0.005) << since;
    EXPECT_LT(std::hypot(now.x - planted.x, now.z - planted.z), 0.006) << since;
  }
  EXPECT_GT(in_hand_at(clip, 0.53, "hand.R", tip).y, 0.04) << "and is in the air in between";
}

TEST(MannequinPush, KeepsBothHandsOnABarThatRollsEvenly) {
  const Playback clip(file(), "push");
  for (double time = 0; time < 1.0; time += 1.0 / 60) {
    const dvec3 root = clip.pose(time)[0].position;
    for (const char* joint : {"hand.L", "hand.R"}) {
      const dvec3 bar = in_hand_at(clip, time, joint, mannequin::handle_in_hand()) - root;
      EXPECT_NEAR(bar.y, mannequin::bar_height, 0.004) << joint << " at " << time;
      EXPECT_NEAR(bar.z, mannequin::bar_ahead, 0.004) << joint << " at " << time;
    }
  }
}

TEST(MannequinTakePicture, HoldsOneCameraInBothHands) {
  const Playback clip(file(), "take picture");
  const dvec3 held = mannequin::camera_in_hand();
  for (double time = 0; time < clip.duration(); time += 1.0 / 30) {
    const double apart = glm::distance(in_hand_at(clip, time, "hand.L", held), in_hand_at(clip, time, "hand.R", held));
    EXPECT_NEAR(apart, 2 * mannequin::hand_from_camera, 0.002) << time;
  }
}

TEST(MannequinDrink, BringsTheCupToTheLipsOnce) {
  const Playback clip(file(), "drink");
  double nearest = 1;
  double farthest = 0;
  for (double time = 0; time < clip.duration(); time += 1.0 / 30) {
    const PosedJoint head = clip.pose(time)[clip.joint("head")];
    const dvec3 lips = head.position + head.rotation * (dvec3(0, 1.604, 0.102) - clip.rest(clip.joint("head")));
    const double away = glm::distance(in_hand_at(clip, time, "hand.R", mannequin::cup_in_hand()), lips);
    nearest = std::min(nearest, away);
    farthest = std::max(farthest, away);
  }
  EXPECT_LT(nearest, 0.075) << "metres from the middle of a cup 11 cm high";
  EXPECT_GT(farthest, 0.4);
}

}  // namespace
}  // namespace throng::test::mannequin_held_test
