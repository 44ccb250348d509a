// However often a fade is interrupted nothing snaps, measured where it would be seen: at joints in model space.

#include <algorithm>
#include <cstring>
#include <functional>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/bake/clip_parts.h"

namespace throng::anim::interruption_test {
namespace {

constexpr int requests = 11;  // ten of them interrupt
constexpr int frames_of_a_fade = 18;

/// The farthest that any joint moves from one frame to the next.
struct LargestStep {
  float metres = 0.0F;
  std::vector<glm::vec3> before;

  void look(const CrowdRig& crowd) {
    std::vector<glm::vec3> now = crowd.joints();
    for (std::size_t i = 0; i < before.size(); ++i) metres = std::max(metres, glm::distance(now[i], before[i]));
    before = std::move(now);
  }
};

struct Motion {
  float largest_step = 0.0F;
  std::size_t deepest = 0;
};

/// A clip after the other, each asked for `frames_between` frames after the one before.
Motion play_in_a_row(Schedule schedule, int frames_between) {
  CrowdRig crowd({.schedule = schedule});
  crowd->agent(0).play({.clip = 0});
  LargestStep largest;
  Motion motion;
  const auto run = [&](int frames) {
    for (int i = 0; i < frames; ++i) {
      crowd.step();
      largest.look(crowd);
      motion.deepest = std::max(motion.deepest, crowd.depth());
    }
  };
  run(10);
  for (int request = 1; request <= requests; ++request) {
    crowd->agent(0).play({.clip = request % 5, .fade = frames_of_a_fade * frame_ticks});
    run(frames_between);
  }
  run(3 * frames_of_a_fade);
  motion.largest_step = largest.metres;
  return motion;
}

TEST(Interruption, TenInARowStepNoFurtherThanTwiceTheMotionWithoutAny) {
  const Motion uninterrupted = play_in_a_row(Schedule::fused, 2 * frames_of_a_fade);
  ASSERT_GT(uninterrupted.largest_step, 0.001F);
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const int frames_between : {1, 2, 3, 5, 9, 17}) {
      EXPECT_LE(play_in_a_row(schedule, frames_between).largest_step, 2.0F * uninterrupted.largest_step)
          << "every " << frames_between << " frames";
    }
  }
}

TEST(Interruption, LeavesTheTreeNoDeeperThanThree) {
  for (const int frames_between : {0, 1, 2, 5}) EXPECT_LE(play_in_a_row(Schedule::fused, frames_between).deepest, 3U);
}

TEST(Interruption, ACutIsFurtherThanThat) {
  CrowdRig crowd;
  LargestStep largest;
  for (int request = 0; request <= requests; ++request) {
    crowd->agent(0).play({.clip = request % 5});
    for (int i = 0; i < 5; ++i) {
      crowd.step();
      largest.look(crowd);
    }
  }
  EXPECT_GT(largest.metres, 2.0F * play_in_a_row(Schedule::fused, 2 * frames_of_a_fade).largest_step)
      << "else the promise above could not be broken";
}

TEST(Interruption, EndsInTheClipThatWasAskedForLast) {
  CrowdRig interrupted;
  interrupted->agent(0).play({.clip = 0});
  interrupted.step(5);
  for (int request = 0; request < 10; ++request) {
    interrupted->agent(0).play({.clip = request % 5, .fade = frames_of_a_fade * frame_ticks});
    interrupted.step(3);
  }
  interrupted->agent(0).play({.clip = 3, .fade = frames_of_a_fade * frame_ticks});
  CrowdRig plain;
  plain->agent(0).play({.clip = 3});
  interrupted.step(60);
  plain.step(60);
  EXPECT_TRUE(interrupted.bones_unlike(plain).empty());
  EXPECT_EQ(interrupted.entities(), 1U);
}

/// How much of each clip is in the agent's pose, 0 to 1: what decides whose data keys are met.
std::map<std::uint32_t, float> shares_of_clips(const AnimationSystem& system) {
  std::map<std::uint32_t, float> shares;
  const PoseWeights weights = system.agent(0).motion().weights(system.clock());
  for (std::size_t i = 0; i < system.agent(0).graph().entities.size(); ++i) {
    const Handle entity = system.agent(0).graph().entities[i];
    if (entity.pool() != EntityPools::sampled_players || weights[i] == 0.0F) continue;
    shares[system.characters().pools(0).as<Player>(entity).clip] += weights[i];
  }
  return shares;
}

/// Asks for three clips, the second while the first fades in, the third `frames` after that.
std::map<std::uint32_t, float> shares_after_three(int frames, const std::function<void(CrowdRig&, int)>& wait) {
  constexpr Ticks fade = frames_of_a_fade * frame_ticks;
  CrowdRig crowd;
  crowd->agent(0).play({.clip = 0});
  crowd.step(5);
  crowd->agent(0).play({.clip = 1, .fade = fade});
  wait(crowd, 3);
  crowd->agent(0).play({.clip = 2, .fade = fade});
  wait(crowd, frames);
  crowd->agent(0).play({.clip = 3, .fade = fade});
  wait(crowd, 4);
  return shares_of_clips(*crowd);
}

TEST(Interruption, IsOverByTheClockWhetherTheAgentIsPosedMeanwhileOrNot) {
  for (const int frames : {0, 1, 2, 17, 18, 19, 40, 100}) {
    const auto posed = shares_after_three(frames, [](CrowdRig& crowd, int wait) { crowd.step(wait); });
    const auto unseen =
        shares_after_three(frames, [](CrowdRig& crowd, int wait) { crowd->advance(wait * frame_ticks); });
    EXPECT_EQ(posed, unseen) << frames << " frames";
    EXPECT_EQ(posed.size(), frames < frames_of_a_fade ? 1U : 2U) << "one that is left has no share";
  }
}

/// The character of the crowds with its bones in another order, and what that order is.
struct OtherOrder {
  BoneOrder order;
  std::shared_ptr<const Character> character;
};

OtherOrder in_other_order() {
  Model model = synthetic_model(40, 5);
  const BoneOrder order = other_order(model.skeleton);
  reorder_bones(model, order);
  return {order, std::make_shared<const Character>(reorder_character(*test_character(), model, order))};
}

/// Interrupts two fades, and gives the bones another order some frames after that if there is one.
CrowdRig interrupted_twice(int frames_before, const OtherOrder* other) {
  constexpr Ticks fade = frames_of_a_fade * frame_ticks;
  CrowdRig crowd;
  for (const int clip : {0, 1, 2}) {
    crowd->agent(0).play({.clip = clip, .fade = fade});
    crowd.step(4);
  }
  crowd->agent(0).play({.clip = 3, .fade = fade});
  crowd.step(frames_before);
  if (other != nullptr) {
    const Status taken = crowd->characters().replace(0, other->character, bone_places(other->order));
    EXPECT_TRUE(taken.has_value()) << taken.error().message;
  }
  crowd.step(3);
  return crowd;
}

TEST(Interruption, GoesOnWhenTheBonesGetAnotherOrder) {
  const OtherOrder other = in_other_order();
  ASSERT_FALSE(std::ranges::is_sorted(other.order.bones)) << "else nothing moves";
  const std::vector<int> before = palette_order(test_character()->skeleton, other.order);
  for (int frames = 0; frames < 6; ++frames) {
    const CrowdRig moved = interrupted_twice(frames, &other), stayed = interrupted_twice(frames, nullptr);
    for (std::size_t entry = 0; entry < before.size(); ++entry) {
      EXPECT_EQ(std::memcmp(moved.palette() + entry, stayed.palette() + before[entry], sizeof(PaletteMatrix)), 0)
          << "entry " << entry << ", " << frames << " frames after the interruption";
    }
  }
}

}  // namespace
}  // namespace throng::anim::interruption_test
