// Local transforms of the clock, against the palettes of pose_exactly.

#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::anim::exact_locals_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::shared_ptr<const Character> stretching_character() {
  Model model = synthetic_model(40, 3);
  model.skeleton.rigid = false;
  for (ReferenceFrame& frame : model.skeleton.references) frame = {};
  model.skeleton.bones[7].prefix[0][0] = 1.5;
  model.skeleton.bones[7].rest.scale = {1.0F, 2.0F, 1.0F};
  return std::make_shared<const Character>(bake_character(model));
}

std::vector<StateTransform> in_double(std::span<const Transform> locals) {
  std::vector<StateTransform> states;
  for (const Transform& local : locals) {
    states.push_back({.rotation = glm::dquat(local.rotation),
                      .position = glm::dvec3(local.translation),
                      .scale = glm::dvec3(local.scale)});
  }
  return states;
}

/// Expects that local transforms say what a palette says.
void expect_agreement(const Skeleton& skeleton, std::span<const Transform> locals, const PaletteMatrix* palette) {
  const ReferencePose pose = pose_from_locals(skeleton, in_double(locals));
  for (std::size_t entry = 0; entry < pose.palette.size(); ++entry) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        EXPECT_NEAR(pose.palette[entry][column][row], palette[entry].rows[row][column], 2e-5)
            << "entry " << entry << " row " << row << " column " << column;
      }
    }
  }
}

/// Agents that are posed ahead of the clock now and then, and fade, and their exact poses in both forms.
void expect_agreement_of(const std::shared_ptr<const Character>& character, const SystemOptions& options) {
  constexpr std::uint32_t agents = 21;
  const auto bones = character->skeleton.bones.size();
  const auto system = std::move(*AnimationSystem::create(character, options));
  system->set_agent_count(agents);
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    system->agent(agent).play({.clip = static_cast<int>(agent % 3), .start = to_ticks(0.05 * agent)});
    system->agent(agent).play({.clip = static_cast<int>((agent + 1) % 3), .fade = to_ticks(0.3)});
    updates.push_back({.agent = {agent}, .look_ahead = 4 * frame_ticks});
  }
  const AlignedBytes memory = allocate_aligned(agents * bones * sizeof(PaletteMatrix));
  const auto palette = [&](std::uint32_t agent) {
    return reinterpret_cast<PaletteMatrix*>(memory.get()) + agent * bones;
  };
  std::vector<Transform> locals(agents * bones);
  std::vector<ExactPose> wanted;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    wanted.push_back(
        {.agent = {agent}, .palette = palette(agent), .locals = std::span(locals).subspan(agent * bones, bones)});
  }
  for (int frame = 0; frame < 8; ++frame) {
    system->advance(frame_ticks);
    if (frame % 4 == 0) system->update(updates);
    system->pose_exactly(wanted);
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      expect_agreement(character->skeleton, wanted[agent].locals, palette(agent));
    }
  }
}

TEST(ExactLocals, SayWhatThePaletteSays) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    expect_agreement_of(test_character(), {.pus = 2, .schedule = schedule});
  }
  expect_agreement_of(test_character(), {.palettes = PaletteFormat::packed});
}

TEST(ExactLocals, OfSkeletonsThatStretchHaveTheirScale) { expect_agreement_of(stretching_character(), {}); }

TEST(ExactLocals, OfBonesThatStandStillAreThoseOfTheFile) {
  Model model = synthetic_model(20, 1);
  model.clips.clear();
  const auto system = std::move(*AnimationSystem::create(std::make_shared<const Character>(bake_character(model)), {}));
  system->set_agent_count(1);
  system->agent(0).play({.clip = 0});
  std::vector<Transform> locals(20);
  const ExactPose wanted{.agent = {0}, .locals = locals};
  system->pose_exactly({&wanted, 1});
  for (std::size_t bone = 0; bone < locals.size(); ++bone) {
    const Transform& rest = model.skeleton.bones[bone].rest;
    EXPECT_LT(glm::distance(locals[bone].translation, rest.translation), 1e-6F);
    EXPECT_GT(std::abs(glm::dot(locals[bone].rotation, rest.rotation)), 1.0F - 1e-6F);
    EXPECT_EQ(locals[bone].scale, rest.scale);
  }
}

TEST(ExactLocals, ChangeNothingAndAllocateNothing) {
  CrowdRig looked_at({}, 3), other({}, 3);
  std::vector<Transform> locals(40);
  const ExactPose wanted{.agent = {1}, .locals = locals};
  for (CrowdRig* crowd : {&looked_at, &other}) {
    for (std::uint32_t agent = 0; agent < 3; ++agent) (*crowd)->agent(agent).play({.clip = static_cast<int>(agent)});
    crowd->step(2);
  }
  looked_at->pose_exactly({&wanted, 1});
  const HotPathCounts before = hot_path_counts();
  for (int i = 0; i < 5; ++i) looked_at->pose_exactly({&wanted, 1});
  EXPECT_EQ((hot_path_counts() - before).allocations, 0U);
  for (CrowdRig* crowd : {&looked_at, &other}) crowd->step(3);
  EXPECT_EQ(looked_at->figures().pose_hash(), other->figures().pose_hash());
}

TEST(ExactLocals, OfNobodyOrWithoutRoomAreReportedAndTheOthersAreWritten) {
  const HeardMisuses listening;
  CrowdRig crowd({}, 2);
  crowd->agent(0).play({.clip = 0});
  std::vector<Transform> good(40, Transform{.scale = glm::vec3(-1.0F)}), few(39);
  const ExactPose wanted[] = {
      {.agent = {7}, .locals = good}, {.agent = {1}, .locals = good}, {.agent = {0}, .locals = few}, {.agent = {0}},
      {.agent = {0}, .locals = good},
  };
  crowd->pose_exactly(wanted);
  EXPECT_THAT(HeardMisuses::all(),
              ElementsAre(HasSubstr("pose_exactly"), HasSubstr("plays something before it is posed"),
                          HasSubstr("room for every bone"), HasSubstr("neither a palette nor local transforms")));
  EXPECT_EQ(good.front().scale, glm::vec3(1.0F));
}

}  // namespace
}  // namespace throng::anim::exact_locals_test
