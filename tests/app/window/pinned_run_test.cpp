// What the demo's own crowd does is pinned: a change that moves every pose, event or place alike is seen here and
// nowhere else. Whoever means to change one of them pins the new value, and says in CHANGELOG.md what moved and why.

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/anim/kernel/kernels.h"
#include "tests/app/program_run.h"

namespace throng::app::pinned_run_test {
namespace {

nlohmann::json statistics_of(const std::string& stream) {
  const ProgramRun run = run_program({"--headless=none", "--agents", "60", "--frames", "240", "--lod", "off",
                                      "--events", "--stream", stream, "--stats", "-"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  return nlohmann::json::parse(run.output);
}

TEST(PinnedRun, OfTheBuiltInCharacterHasThePinnedPoses) {
  if (!anim::best_kernels().fused_multiply_add) return;  // other targets round poses differently
  EXPECT_EQ(statistics_of("sampled").at("pose_hash"), "9ffb0250f0c96e0f");
  EXPECT_EQ(statistics_of("keyframe").at("pose_hash"), "85be6bb7b14cc347");
}

TEST(PinnedRun, HasThePinnedEventsAndPlacesWithEitherStream) {
  for (const char* const stream : {"sampled", "keyframe"}) {
    const nlohmann::json statistics = statistics_of(stream);
    EXPECT_EQ(statistics.at("events"), 190);
    EXPECT_EQ(statistics.at("event_hash"), "da158733d7789e37");
    EXPECT_EQ(statistics.at("place_hash"), "23fee01a6d027250");
  }
}

}  // namespace
}  // namespace throng::app::pinned_run_test
