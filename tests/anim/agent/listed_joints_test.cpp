// What an update writes beside a palette, or instead of it: listed joints, palettes of a skin, 4x4 matrices.

#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/anim/kernel/palette/joint_rig.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::anim::listed_joints_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint32_t agents = 37;
constexpr std::size_t floats_each = 1024;

const Skeleton& skeleton() { return test_character()->skeleton; }

/// A crowd that blends, whose joints are written where a test reads them.
class JointCrowd {
 public:
  explicit JointCrowd(const SystemOptions& options = {}, bool fades = false)
      : crowd_(options, agents), memory_(allocate_aligned(agents * floats_each * sizeof(float))) {
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      crowd_->agent(agent).play({.clip = static_cast<int>(agent % 3), .start = to_ticks(0.03 * agent)});
      if (agent % 2 == 0) crowd_->agent(agent).play({.clip = 3, .held_fraction = 0.4F});
      if (fades) crowd_->agent(agent).play({.clip = 4, .fade = to_ticks(0.1)});
    }
  }

  Status list(const JointList& joints, JointFormat format) { return crowd_->characters().write_joints(joints, format); }
  void step(int frames, bool palettes, std::uint8_t level = 0) {
    std::vector<PoseRequest> updates;
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      const PaletteMatrix* const palette = crowd_.palette(agent);
      updates.push_back({.agent = {agent},
                         .level = level,
                         .palette = palettes ? memory_of(palette) : nullptr,
                         .joints = memory_.get() + agent * floats_each * sizeof(float)});
    }
    for (int frame = 0; frame < frames; ++frame) {
      crowd_->advance(frame_ticks);
      crowd_->update(updates);
    }
  }

  template <typename T = float>
  const T* joints(std::uint32_t agent) const {
    return reinterpret_cast<const T*>(memory_.get() + agent * floats_each * sizeof(float));
  }
  const PaletteMatrix* palette(std::uint32_t agent) const { return crowd_.palette(agent); }
  const CrowdRig& rig() const { return crowd_; }
  AnimationSystem& operator*() const { return *crowd_; }
  AnimationSystem* operator->() const { return &*crowd_; }

 private:
  CrowdRig crowd_;
  AlignedBytes memory_;
};

bool same_joints(const JointCrowd& a, const JointCrowd& b, std::size_t bytes) {
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    if (std::memcmp(a.joints(agent), b.joints(agent), bytes) != 0) return false;
  }
  return true;
}

TEST(ListedJoints, AreWhereThePaletteSays) {
  JointCrowd crowd;
  ASSERT_TRUE(crowd.list(all_joints(skeleton()), JointFormat::transforms));
  EXPECT_EQ(crowd->characters().joint_bytes(), static_cast<std::size_t>(skeleton().bone_count()) * 32);
  crowd.step(5, true);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    const std::vector<glm::vec3> expected = crowd.rig().joints(agent);
    for (std::size_t bone = 0; bone < expected.size(); ++bone) {
      const float* const at = crowd.joints<JointTransform>(agent)[bone].position;
      EXPECT_LT(glm::distance(glm::vec3(at[0], at[1], at[2]), expected[bone]), 2e-6F) << agent << " " << bone;
    }
  }
}

TEST(ListedJoints, AloneHaveTheBitsThatTheyHaveBesideAPaletteUnderEverySchedule) {
  const JointList few{{.bone = 25}, {.bone = 3}, {.bone = 39}};
  for (const StreamKind stream : {StreamKind::sampled, StreamKind::keyframe}) {
    for (const bool fades : {false, true}) {
      JointCrowd beside({.stream = stream}, fades);
      ASSERT_TRUE(beside.list(few, JointFormat::matrices));
      beside.step(20, true);
      for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
        for (const bool hash : {false, true}) {
          const int tile = stream == StreamKind::sampled ? 4 : 0;
          JointCrowd alone({.pus = 3, .tile = tile, .schedule = schedule, .stream = stream, .hash = hash}, fades);
          ASSERT_TRUE(alone.list(few, JointFormat::matrices));
          alone.step(20, false);
          EXPECT_TRUE(same_joints(alone, beside, 3 * sizeof(PaletteMatrix))) << hash << fades;
          if (hash) {
            EXPECT_EQ(alone->figures().pose_hash(), beside->figures().pose_hash());
          }
        }
      }
    }
  }
}

TEST(ListedJoints, AloneLeaveNothingBehindThatALaterPaletteMisses) {
  JointCrowd alone({.hash = false}, true), always({.hash = false}, true);
  for (JointCrowd* crowd : {&alone, &always}) ASSERT_TRUE(crowd->list({{.bone = 2}}, JointFormat::matrices));
  for (JointCrowd* crowd : {&alone, &always}) {
    crowd->step(2, crowd == &always);
    for (std::uint32_t agent = 0; agent < agents; ++agent) {  // while it fades
      (*crowd)->agent(agent).play({.clip = 0, .fade = to_ticks(0.2)});
    }
    crowd->step(3, crowd == &always);
    crowd->step(1, true);
  }
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    EXPECT_TRUE(alone.rig().bones_unlike(always.rig(), agent).empty()) << agent;
  }
}

TEST(ListedJoints, OfThePaletteAreItsEntriesAndARowToTheBit) {
  JointCrowd crowd;
  ASSERT_TRUE(crowd.list(kernel_rig::palette_joints(skeleton()), JointFormat::matrices_4x4));
  crowd.step(3, true);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    for (int entry = 0; entry < skeleton().palette_count(); ++entry) {
      for (int column = 0; column < 4; ++column) {
        const float* const actual = crowd.joints<Matrix4x4>(agent)[entry].columns[column];
        for (int row = 0; row < 3; ++row) EXPECT_EQ(actual[row], crowd.palette(agent)[entry].rows[row][column]);
        EXPECT_EQ(actual[3], column == 3 ? 1.0F : 0.0F);
      }
    }
  }
}

TEST(ListedJoints, DoNotChangePalettesOrTheirHash) {
  JointCrowd with, without;
  ASSERT_TRUE(with.list(all_joints(skeleton()), JointFormat::matrices));
  with.step(5, true);
  CrowdRig plain({}, agents);
  ASSERT_TRUE(without.list(all_joints(skeleton()), JointFormat::matrices));
  ASSERT_TRUE(without.list({}, JointFormat::matrices));
  EXPECT_EQ(without->characters().joint_bytes(), 0U);
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    updates.push_back({.agent = {agent}, .palette = memory_of(without.palette(agent))});
  }
  for (int frame = 0; frame < 5; ++frame) {
    without->advance(frame_ticks);
    without->update(updates);
  }
  EXPECT_EQ(with->figures().pose_hash(), without->figures().pose_hash());
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    EXPECT_TRUE(with.rig().bones_unlike(without.rig(), agent).empty());
  }
}

TEST(ListedJoints, AreWrittenAtEveryBoneLevel) {
  const auto levels = static_cast<std::uint8_t>(skeleton().level_bone_counts.size());
  ASSERT_GT(levels, 1);
  for (std::uint8_t level = 0; level < levels; ++level) {
    JointCrowd crowd;
    ASSERT_TRUE(crowd.list(kernel_rig::palette_joints(skeleton()), JointFormat::matrices));
    crowd.step(2, true, level);
    const int kept = skeleton().level_bone_counts[level];
    for (int bone = 0; bone < skeleton().bone_count(); ++bone) {
      const int shown = nearest_kept_bone(skeleton(), bone, kept);
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
          EXPECT_NEAR(crowd.joints<PaletteMatrix>(3)[bone].rows[row][column], crowd.palette(3)[shown].rows[row][column],
                      2e-6F)
              << "bone " << bone << " of level " << int{level};
        }
      }
    }
  }
}

// A thing in a hand goes with the skin of the hand, with all bones and with few, also while clips fade.
TEST(ListedJoints, CarryAThingWithinATenthOfAMillimetreOfTheSkinAtEveryBoneLevel) {
  const auto levels = static_cast<std::uint8_t>(skeleton().level_bone_counts.size());
  for (std::uint8_t level = 0; level < levels; ++level) {
    JointCrowd crowd({}, true);
    ASSERT_TRUE(crowd.list(all_joints(skeleton()), JointFormat::transforms));
    for (int frame = 0; frame < 12; ++frame) {
      crowd.step(1, true, level);
      for (int bone = 0; bone < skeleton().bone_count(); ++bone) {
        const int shown = nearest_kept_bone(skeleton(), bone, skeleton().level_bone_counts[level]);
        const glm::vec3 rest(joint_place(skeleton(), bone).position);
        const auto& rows = crowd.palette(5)[joint_place(skeleton(), shown).entry].rows;
        const float* const at = crowd.joints<JointTransform>(5)[bone].position;
        for (int axis = 0; axis < 3; ++axis) {
          const float skin = rows[axis][0] * rest.x + rows[axis][1] * rest.y + rows[axis][2] * rest.z + rows[axis][3];
          EXPECT_NEAR(at[axis], skin, 1e-4F) << "bone " << bone << " of level " << int{level};
        }
      }
    }
  }
}

// A list that needed scratch of its own would halve the tile, which costs four tenths of an update.
TEST(ListedJoints, LeaveTilesAsManyAgentsAsTheyHadInAStoreOfAnySize) {
  const auto width_in = [](std::size_t bytes, const JointList& joints) {
    JointCrowd crowd({.local_store_bytes = bytes});
    EXPECT_TRUE(crowd.list(joints, JointFormat::matrices));
    return crowd->figures().schedule().plan.width;
  };
  constexpr std::size_t kib = 1024, for_pointers = 512;
  int widest = 0;
  for (std::size_t bytes = 24 * kib; bytes <= 96 * kib; bytes += kib / 2) {
    const int width = width_in(bytes, {});
    EXPECT_GE(width_in(bytes + for_pointers, {{.bone = 25}}), width) << bytes;
    widest = std::max(widest, width);
  }
  EXPECT_EQ(widest, widest_strip);
}

TEST(ListedJoints, BesidePackedPalettesHaveTheBitsThatTheyHaveBesideMatrices) {
  const JointList few{{.bone = 25}, {.bone = 3}, {.bone = 39}};
  JointCrowd matrices, packed({.palettes = PaletteFormat::packed});
  for (JointCrowd* crowd : {&matrices, &packed}) {
    ASSERT_TRUE(crowd->list(few, JointFormat::matrices));
    crowd->step(5, true);
  }
  ASSERT_EQ(packed->characters().palette_format({0}), PaletteFormat::packed);
  EXPECT_TRUE(same_joints(matrices, packed, few.size() * sizeof(PaletteMatrix)));
}

TEST(ListedJoints, OfSomeAgentsDoNotDisturbTheOthers) {
  JointCrowd crowd;
  ASSERT_TRUE(crowd.list(all_joints(skeleton()), JointFormat::transforms));
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < agents; ++agent) updates.push_back({.agent = {agent}});
  alignas(16) JointTransform one[40];
  updates[11].joints = PaletteDestination(one).memory();
  crowd->update(updates);
  JointCrowd other;
  ASSERT_TRUE(other.list(all_joints(skeleton()), JointFormat::transforms));
  other.step(1, true);
  crowd->advance(frame_ticks);
  crowd->update(updates);
  EXPECT_EQ(std::memcmp(one, other.joints(11), sizeof(one)), 0);
}

TEST(ListedJoints, AllocateNothingInAFrame) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    JointCrowd crowd({.schedule = schedule, .hash = false});
    ASSERT_TRUE(crowd.list(all_joints(skeleton()), JointFormat::matrices));
    std::vector<PoseRequest> updates;
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      updates.push_back({.agent = {agent}, .joints = memory_of(crowd.joints<PaletteMatrix>(agent))});
    }
    crowd->update(updates);
    const HotPathCounts before = hot_path_counts();
    for (int frame = 0; frame < 5; ++frame) {
      crowd->advance(frame_ticks);
      crowd->update(updates);
    }
    EXPECT_EQ((hot_path_counts() - before).allocations, 0U);
  }
}

TEST(ListedJoints, ThatNobodyCanWriteAreRefusedAndNothingChanges) {
  JointCrowd crowd;
  ASSERT_TRUE(crowd.list({{.bone = 1}}, JointFormat::matrices));
  const Status refused = crowd.list({{.bone = 40}}, JointFormat::matrices);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("joint 0 is of bone 40: give 0 to 39"));
  EXPECT_EQ(crowd->characters().joint_bytes(), sizeof(PaletteMatrix));
  const HeardMisuses listening;
  EXPECT_FALSE(crowd->characters().write_joints({{.bone = 1}}, JointFormat::matrices, CharacterId{7}));
  EXPECT_THAT(HeardMisuses::all(), ElementsAre(HasSubstr("Crowd::write_joints")));
}

TEST(ListedJoints, AtABadPlaceOrOfACharacterWithoutAListAreReported) {
  const HeardMisuses listening;
  CrowdRig crowd({}, 1);
  crowd->agent(0).play({.clip = 0});
  alignas(64) std::byte memory[2048];
  PoseRequest update{.agent = {0}, .joints = memory};
  crowd->update({&update, 1});
  EXPECT_THAT(HeardMisuses::all(), ElementsAre(HasSubstr("lists no joints: call Crowd::write_joints first")));
  HeardMisuses::all().clear();
  ASSERT_TRUE(crowd->characters().write_joints(all_joints(skeleton()), JointFormat::transforms));
  update.joints = memory + 4;
  crowd->update({&update, 1});
  EXPECT_THAT(HeardMisuses::all(), ElementsAre(HasSubstr("joints lie at a multiple of 16 bytes")));
}

TEST(ListedJoints, KeepTheOrderOfTheBones) {
  JointCrowd crowd;
  ASSERT_TRUE(crowd.list({{.bone = 1}}, JointFormat::matrices));
  std::vector<int> places(40);
  std::iota(places.begin(), places.end(), 0);
  std::swap(places[38], places[39]);
  const Status replaced = crowd->characters().replace({0}, test_character(), places);
  ASSERT_FALSE(replaced);
  EXPECT_THAT(replaced.error().message, HasSubstr("a list of joints"));
}

}  // namespace
}  // namespace throng::anim::listed_joints_test
