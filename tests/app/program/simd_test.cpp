// One run of the program on every SIMD target of this machine. Targets with fused multiply-add give the same poses to
// the bit; the others are held to double precision by the tests of the kernels, and to a picture by tests/golden.
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/anim/kernel/choose_kernels.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/app/program_run.h"

namespace throng::app::simd_test {
namespace {

/// The statistics of one run; each is made once.
const nlohmann::json& statistics_on(std::string_view target, std::string_view stream) {
  static std::map<std::string, nlohmann::json> known;
  const auto [entry, is_new] = known.try_emplace(std::string(target) + std::string(stream));
  if (!is_new) return entry->second;
  const ProgramRun run = run_program({"--headless=none", "--agents", "30", "--frames", "60", "--lod", "off", "--events",
                                      "--stream", std::string(stream), "--simd", std::string(target), "--stats", "-"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  return entry->second = nlohmann::json::parse(run.output);
}

TEST(Simd, EveryTargetWithFusedMultiplyAddGivesTheSamePoses) {
  for (const char* const stream : {"sampled", "keyframe"}) {
    std::set<nlohmann::json> fused_hashes;
    for (const anim::Kernels& kernels : anim::runnable_kernels()) {
      const nlohmann::json& statistics = statistics_on(kernels.target, stream);
      EXPECT_EQ(statistics.at("simd_target"), kernels.target);
      if (kernels.fused_multiply_add) fused_hashes.insert(statistics.at("pose_hash"));
    }
    EXPECT_LE(fused_hashes.size(), 1U) << nlohmann::json(fused_hashes);
  }
}

TEST(Simd, EveryTargetGivesTheSameEventsAndPlaces) {
  const nlohmann::json& best = statistics_on(anim::best_kernels().target, "sampled");
  EXPECT_GT(best.at("events"), 0);
  for (const anim::Kernels& kernels : anim::runnable_kernels()) {
    const nlohmann::json& statistics = statistics_on(kernels.target, "sampled");
    for (const char* const key : {"events", "event_hash", "place_hash"}) {
      EXPECT_EQ(statistics.at(key), best.at(key)) << kernels.target << " " << key;
    }
  }
}

TEST(Simd, IsSaidByTheBench) {
  const ProgramRun run =
      run_program({"bench", "--agents", "10", "--frames", "1", "--pus", "1", "--simd", "scalar", "--json", "-"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_THAT(run.output, testing::HasSubstr("\"simd_target\": \"SCALAR\""));
}

TEST(Simd, ThatIsMissingIsRefusedWithWhatThereIs) {
  std::string names;
  const std::vector<std::string> targets = anim::runnable_targets();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (i > 0) names += i + 1 < targets.size() ? ", " : " and ";
    names += targets[i];
  }
  for (const std::string command : {"", "bench", "lod"}) {
    std::vector<std::string> line{"--simd", "mmx"};
    if (!command.empty()) line.insert(line.begin(), command);
    const ProgramRun run = run_program(line);
    EXPECT_EQ(run.exit_status, 2);
    EXPECT_EQ(run.errors, "throng: --simd mmx: this processor and build have " + names + "\n");
  }
}

}  // namespace
}  // namespace throng::app::simd_test
