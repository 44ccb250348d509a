#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/assets/character_file.h"

namespace throng::test {
namespace {

constexpr double key_rate = 30;
constexpr double shoes = 4;

class MannequinMotion : public ::testing::TestWithParam<const char*> {
 protected:
  CharacterFile file_ = CharacterFile::committed();
  Playback clip_{file_, GetParam()};
  std::vector<double> region_ = file_.attribute("_REGION");

  [[nodiscard]] double angle(double time, const char* joint) const {
    const glm::dquat local = clip_.pose(time)[clip_.joint(joint)].local;
    return glm::degrees(2 * std::acos(std::min(1.0, std::abs(local.w))));
  }
};

TEST_P(MannequinMotion, HasKeysOnAGridOfThirtyHertz) {
  for (std::size_t key = 0; key < clip_.key_count(); ++key) {
    EXPECT_NEAR(clip_.key_time(key), static_cast<double>(key) / key_rate, 1e-6);
  }
}

TEST_P(MannequinMotion, EndsWhereItBegan) {
  const std::vector<PosedJoint> first = clip_.pose(0);
  const std::vector<PosedJoint> last = clip_.pose(clip_.duration());
  const glm::dvec3 way = last[0].position - first[0].position;
  for (std::size_t j = 0; j < first.size(); ++j) {
    EXPECT_LT(glm::distance(first[j].position + way, last[j].position), 1e-4) << file_.joint_names()[j];
  }
}

/// The largest change of a joint's velocity at a key, in metres per key squared, the loop's seam taken as any key.
class Roughness {
 public:
  explicit Roughness(const Playback& clip) : keys_(clip.key_count() - 1) {
    for (std::size_t key = 0; key < keys_; ++key) poses_.push_back(clip.pose(clip.key_time(key)));
    way_ = clip.pose(clip.duration())[0].position - poses_[0][0].position;
  }
  [[nodiscard]] double at(std::size_t key, std::size_t joint) const {
    return glm::length(place(key + keys_ + 1, joint) - 2.0 * place(key + keys_, joint) + place(key + keys_ - 1, joint));
  }
  [[nodiscard]] double away_from_seam(std::size_t joint) const {
    double most = 0;
    for (std::size_t key = 2; key + 1 < keys_; ++key) most = std::max(most, at(key, joint));
    return most;
  }

 private:
  [[nodiscard]] glm::dvec3 place(std::size_t key, std::size_t joint) const {
    return poses_[key % keys_][joint].position + static_cast<double>(key / keys_) * way_;
  }
  std::size_t keys_;
  std::vector<std::vector<PosedJoint>> poses_;
  glm::dvec3 way_{};
};

TEST_P(MannequinMotion, IsNoRougherAtTheSeamThanWhereTheOtherSideDoesTheSame) {
  const Roughness roughness(clip_);
  const std::vector<std::string> names = file_.joint_names();
  for (std::size_t j = 0; j < names.size(); ++j) {
    std::string other = names[j];
    if (other.ends_with(".L")) other.back() = 'R';
    if (names[j].ends_with(".R")) other.back() = 'L';
    const double elsewhere = std::max(roughness.away_from_seam(j), roughness.away_from_seam(clip_.joint(other)));
    EXPECT_LT(roughness.at(0, j), 1.01 * elsewhere + 1e-4) << names[j];
  }
}

TEST_P(MannequinMotion, KeepsEveryVertexOfAPlantedSoleWithinFiveMillimetres) {
  constexpr double touching = 0.004;
  const auto steps = static_cast<int>(std::lround(clip_.duration() * 120));
  std::vector<glm::dvec3> landed(region_.size());
  std::vector<bool> planted(region_.size(), false);
  double worst = 0;
  for (int step = 0; step <= steps; ++step) {
    const std::vector<glm::dvec3> skin = clip_.skin(clip_.duration() * step / steps);
    for (std::size_t v = 0; v < skin.size(); ++v) {
      if (region_[v] != shoes) continue;
      const bool touches = skin[v].y < touching;
      if (touches && !planted[v]) landed[v] = skin[v];
      if (touches) worst = std::max(worst, std::hypot(skin[v].x - landed[v].x, skin[v].z - landed[v].z));
      planted[v] = touches;
    }
  }
  EXPECT_LT(worst, 0.005);
}

TEST_P(MannequinMotion, StaysAboveTheGround) {
  double lowest = 0;
  for (double time = 0; time < clip_.duration(); time += 1.0 / 60) {
    for (const glm::dvec3& vertex : clip_.skin(time)) lowest = std::min(lowest, vertex.y);
  }
  EXPECT_GT(lowest, -0.006);
}

TEST_P(MannequinMotion, BendsNoJointBeyondAHumansRange) {
  struct Range {
    const char* joint;
    double most;  ///< Degrees from rest.
  };
  constexpr std::array<Range, 16> ranges{{{"spine", 25},
                                          {"chest", 25},
                                          {"upper_chest", 25},
                                          {"neck", 35},
                                          {"head", 40},
                                          {"jaw", 25},
                                          {"shoulder.L", 35},
                                          {"shoulder.R", 35},
                                          {"forearm.L", 150},
                                          {"forearm.R", 150},
                                          {"hand.L", 70},
                                          {"hand.R", 70},
                                          {"shin.L", 140},
                                          {"shin.R", 140},
                                          {"foot.L", 50},
                                          {"foot.R", 50}}};
  for (double time = 0; time < clip_.duration(); time += 1.0 / 60) {
    for (const Range& range : ranges) EXPECT_LE(angle(time, range.joint), range.most) << range.joint << " at " << time;
  }
}

TEST_P(MannequinMotion, BendsKneesOnlyBackwards) {
  for (double time = 0; time < clip_.duration(); time += 1.0 / 60) {
    const std::vector<PosedJoint> pose = clip_.pose(time);
    for (const char* knee : {"shin.L", "shin.R"}) EXPECT_GT(pose[clip_.joint(knee)].local.x, -0.01) << knee;
  }
}

INSTANTIATE_TEST_SUITE_P(Clips, MannequinMotion,
                         ::testing::Values("idle", "walk", "cheer", "wave", "clap", "jog", "run"),
                         [](const auto& clip) { return std::string(clip.param); });

TEST(MannequinClips, AreListedInAFixedOrderThatOthersRelyOn) {
  EXPECT_EQ(clip_names(CharacterFile::committed()),
            (std::vector<std::string>{"idle", "walk", "cheer", "wave", "clap", "jog", "run"}));
}

TEST(MannequinWalk, TravelsEvenlyAlongPositiveZAtWalkingSpeed) {
  const Playback walk(CharacterFile::committed(), "walk");
  EXPECT_NEAR(walk.pose(walk.duration())[0].position.z / walk.duration(), 1.35, 1e-4);
  for (std::size_t key = 0; key < walk.key_count(); ++key) {
    const glm::dvec3 root = walk.pose(walk.key_time(key))[0].position;
    EXPECT_NEAR(root.z, 1.35 * walk.key_time(key), 1e-5);
    EXPECT_EQ(root.x, 0);
    EXPECT_EQ(root.y, 0);
  }
}

TEST(MannequinWalk, TurnsShouldersAgainstHipsAndKeepsTheHeadCalm) {
  const Playback walk(CharacterFile::committed(), "walk");
  const auto heading = [&](double time, const char* joint) {
    const glm::dvec3 forward = walk.pose(time)[walk.joint(joint)].rotation * glm::dvec3(0, 0, 1);
    return glm::degrees(std::atan2(forward.x, forward.z));
  };
  double opposed = 0;
  double head_swing = 0;
  double chest_swing = 0;
  for (double time = 0; time < walk.duration(); time += 1.0 / 60) {
    opposed += heading(time, "hips") * heading(time, "upper_chest");
    chest_swing = std::max(chest_swing, std::abs(heading(time, "upper_chest")));
    head_swing = std::max(head_swing, std::abs(heading(time, "head")));
  }
  EXPECT_LT(opposed, 0);
  EXPECT_GT(chest_swing, 3);
  EXPECT_LT(head_swing, 2);
}

}  // namespace
}  // namespace throng::test
