#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets/mannequin/skeleton.h"
#include "tests/assets/character_file.h"
#include "tests/assets/clip_list.h"

namespace throng::test::mannequin_range_test {
namespace {

using glm::dquat;
using glm::dvec3;

constexpr dvec3 right_of_itself{1, 0, 0};
constexpr dvec3 upwards{0, 1, 0};

/// Which way a joint's limb runs at rest, and how far a healthy adult turns it, degrees from rest: away from that
/// direction, and about it (Norkin and White, Measurement of Joint Motion; shares of the spine after White and
/// Panjabi).
struct Range {
  const char* joint;
  dvec3 along;
  double swing, twist;
};

struct Turn {
  double swing, twist;
};

Turn turn_of(const dquat& rotation, dvec3 along) {
  const double about = glm::dot(dvec3(rotation.x, rotation.y, rotation.z), along);
  const double twist = 2 * std::atan2(about, rotation.w);
  const dvec3 swung = rotation * along;
  return {glm::degrees(std::atan2(glm::length(glm::cross(along, swung)), glm::dot(along, swung))),
          glm::degrees(std::remainder(twist, 2 * std::acos(-1.0)))};
}

dquat mirrored(const dquat& q) { return {q.w, q.x, -q.y, -q.z}; }

class MannequinRange : public ::testing::TestWithParam<const char*> {
 protected:
  CharacterFile file_ = CharacterFile::committed();
  Playback clip_{file_, GetParam()};

  /// A joint's local rotation, as if it were of the left side.
  [[nodiscard]] dquat left_rotation(const std::vector<PosedJoint>& pose, const std::string& joint) const {
    const dquat local = pose[clip_.joint(joint)].local;
    return joint.ends_with(".R") ? mirrored(local) : local;
  }

  template <typename Check>
  void at_all_times(const Check& check) const {
    for (double time = 0; time <= clip_.duration(); time += 1.0 / 60) check(time, clip_.pose(time));
  }
};

TEST_P(MannequinRange, TurnsNoJointFurtherThanAHumanCan) {
  const dvec3 arm = mannequin::left_arm().along;
  const std::array<Range, 13> ranges{{{"spine", upwards, 25, 12},
                                      {"chest", upwards, 25, 15},
                                      {"upper_chest", upwards, 20, 15},
                                      {"neck", upwards, 35, 45},
                                      {"head", upwards, 40, 50},
                                      {"jaw", upwards, 25, 3},
                                      {"eye", dvec3(0, 0, 1), 35, 5},
                                      {"shoulder", right_of_itself, 35, 30},
                                      {"upper_arm", arm, 140, 100},
                                      {"hand", arm, 75, 90},
                                      {"thigh", upwards, 122, 50},
                                      {"foot", upwards, 52, 30},
                                      {"toe", dvec3(0, 0, 1), 65, 5}}};
  at_all_times([&](double time, const std::vector<PosedJoint>& pose) {
    for (const Range& range : ranges) {
      for (const char* suffix : {"", ".L", ".R"}) {
        const std::string joint = std::string(range.joint) + suffix;
        const auto names = file_.joint_names();
        if (std::find(names.begin(), names.end(), joint) == names.end()) continue;
        const Turn turn = turn_of(left_rotation(pose, joint), range.along);
        EXPECT_LE(turn.swing, range.swing) << joint << " at " << time;
        EXPECT_LE(std::abs(turn.twist), range.twist) << joint << " at " << time;
      }
    }
  });
}

TEST_P(MannequinRange, BendsKneesAndElbowsAsHingesAndOneWayOnly) {
  const dvec3 elbow_axis = glm::normalize(glm::cross(mannequin::left_arm().along, dvec3(0, 0, 1)));
  at_all_times([&](double time, const std::vector<PosedJoint>& pose) {
    for (const char* suffix : {".L", ".R"}) {
      const Turn knee = turn_of(left_rotation(pose, std::string("shin") + suffix), right_of_itself);
      EXPECT_GT(knee.twist, -1) << "knee" << suffix << " at " << time;
      EXPECT_LT(knee.twist, 145) << "knee" << suffix << " at " << time;
      EXPECT_LT(knee.swing, 1) << "knee" << suffix << " at " << time;
      const Turn elbow = turn_of(left_rotation(pose, std::string("forearm") + suffix), elbow_axis);
      EXPECT_LT(std::abs(elbow.twist), 150) << "elbow" << suffix << " at " << time;
      EXPECT_LT(elbow.swing, 1) << "elbow" << suffix << " at " << time;
      const dvec3 bent = left_rotation(pose, std::string("forearm") + suffix) * mannequin::left_arm().along;
      EXPECT_GT(bent.z, -0.02) << "elbow" << suffix << " bends forward, at " << time;
    }
  });
}

TEST_P(MannequinRange, StretchesHipsBackAndSpreadsThemNoFurtherThanAHumanCan) {
  at_all_times([&](double time, const std::vector<PosedJoint>& pose) {
    for (const char* joint : {"thigh.L", "thigh.R"}) {
      const dvec3 thigh = left_rotation(pose, joint) * -upwards;
      EXPECT_GT(glm::degrees(std::atan2(thigh.z, -thigh.y)), -32) << joint << " stretched, at " << time;
      EXPECT_LT(glm::degrees(std::asin(thigh.x)), 45) << joint << " spread, at " << time;
      EXPECT_GT(glm::degrees(std::asin(thigh.x)), -30) << joint << " crossed, at " << time;
    }
  });
}

TEST_P(MannequinRange, TurnsHeadAndTrunkAsAWholeNoFurtherThanAHumanCan) {
  at_all_times([&](double time, const std::vector<PosedJoint>& pose) {
    const auto between = [&](const char* lower, const char* upper) {
      return turn_of(glm::inverse(pose[clip_.joint(lower)].rotation) * pose[clip_.joint(upper)].rotation, upwards);
    };
    EXPECT_LT(std::abs(between("upper_chest", "head").twist), 75) << time;
    EXPECT_LT(between("upper_chest", "head").swing, 55) << time;
    EXPECT_LT(std::abs(between("hips", "upper_chest").twist), 40) << time;
    EXPECT_LT(between("hips", "upper_chest").swing, 55) << time;
  });
}

/// How alike two series are, 1 if one is a multiple of the other.
double likeness(const std::vector<dvec3>& a, const std::vector<dvec3>& b) {
  double both = 0;
  double first = 0;
  double second = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += glm::length(a[i]) * glm::length(b[i]);
    first += glm::dot(a[i], a[i]);
    second += glm::dot(b[i], b[i]);
  }
  return both / std::sqrt(first * second);
}

/// Of the joints that shape a movement, each has a rhythm of its own: the speeds of no two go up and down together.
TEST_P(MannequinRange, MovesNoTwoJointsInLockstep) {
  constexpr std::array<const char*, 12> joints{"hips",   "spine",      "chest",       "upper_chest",
                                               "head",   "shoulder.L", "upper_arm.L", "forearm.L",
                                               "hand.L", "thigh.L",    "shin.L",      "foot.L"};
  constexpr double step = 1.0 / 60;
  std::array<std::vector<dvec3>, joints.size()> speeds;
  for (double time = step; time <= clip_.duration(); time += step) {
    const auto before = clip_.pose(time - step);
    const auto after = clip_.pose(time);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const dquat change = glm::inverse(before[clip_.joint(joints[j])].local) * after[clip_.joint(joints[j])].local;
      speeds[j].emplace_back(change.x, change.y, change.z);
    }
  }
  for (std::size_t a = 0; a < joints.size(); ++a) {
    for (std::size_t b = a + 1; b < joints.size(); ++b) {
      EXPECT_LT(likeness(speeds[a], speeds[b]), 0.9995) << joints[a] << " and " << joints[b];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Clips, MannequinRange, ::testing::ValuesIn(clip_list), spaceless_clip_name);

}  // namespace
}  // namespace throng::test::mannequin_range_test
