// Bytes and transfers are a closed form of the schedule, equal in every mode of double buffering.

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::copy_counts_test {
namespace {

constexpr std::uint32_t agents = 37;
constexpr int bones = 62;
constexpr std::uint64_t header = 128;
constexpr std::uint64_t changing = header - identity_bytes;  // what updates of our kinds read and write of it
constexpr std::uint64_t pose = 1792;

std::shared_ptr<const Character> character() {
  static const auto shared = std::make_shared<const Character>(bake_character(synthetic_model(bones, 2)));
  return shared;
}

CopyCounts counts_of_one_frame(SystemOptions options, StreamKind stream, int pus) {
  options.stream = stream;
  options.pus = pus;
  auto system = AnimationSystem::create(character(), options);
  EXPECT_TRUE(system.has_value());
  (*system)->set_agent_count(agents);
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    (*system)->agent(agent).play({.clip = 0});
    (*system)->agent(agent).play({.clip = 1, .fade = ticks_per_second});
    updates.push_back({.agent = {agent}});
  }
  (*system)->advance(ticks_per_second / 60);
  (*system)->update(updates);
  return (*system)->figures().report().copies;
}

void expect_in_every_mode(Schedule schedule, StreamKind stream, const CopyCounts& expected) {
  for (const auto mode : {DoubleBuffering::off, DoubleBuffering::inline_copy, DoubleBuffering::interleaved}) {
    for (const int pus : {1, 3}) {
      const CopyCounts counts = counts_of_one_frame({.schedule = schedule, .double_buffering = mode}, stream, pus);
      EXPECT_EQ(counts.bytes_in, expected.bytes_in);
      EXPECT_EQ(counts.bytes_out, expected.bytes_out);
      EXPECT_EQ(counts.transfers, expected.transfers);
    }
  }
}

TEST(CopyCounts, FusedFetchesALineOfEachOfThreeTransientBlocksAnAgentAndWritesItBack) {
  expect_in_every_mode(
      Schedule::fused, StreamKind::sampled,
      {.bytes_in = agents * 3 * changing, .bytes_out = agents * 3 * changing, .transfers = agents * (3 + 3)});
}

TEST(CopyCounts, FusedKeyframePlayersBringTheirInterpolationStructuresAlong) {
  const std::uint64_t structures = (interpolation_bytes(bones, rigid_components) + 63) / 64 * 64;
  expect_in_every_mode(Schedule::fused, StreamKind::keyframe,
                       {.bytes_in = agents * (3 * changing + 2 * structures),
                        .bytes_out = agents * (3 * changing + 2 * structures),
                        .transfers = agents * (3 + 3)});
}

TEST(CopyCounts, LevelsMovesWholeStatesAndNeverWritesASourceBack) {
  const std::uint64_t state = header + pose;
  const std::uint64_t packets = 4;
  expect_in_every_mode(Schedule::levels, StreamKind::sampled,
                       {.bytes_in = agents * (2 * state + 3 * state + pose),
                        .bytes_out = agents * 3 * state,
                        .transfers = agents * (2 * 2 + 4 + packets)});
}

}  // namespace
}  // namespace throng::anim::copy_counts_test
