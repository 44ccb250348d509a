// No order of calls and no number brings the library down, whatever the caller gets wrong.
//
//     THRONG_RANDOM_SECONDS=3600 build/release/tests/throng_api_tests --gtest_filter='RandomCalls.*'

#include "tests/api/random_calls.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/api/api_crowd.h"

namespace throng::random_calls_test {
namespace {

/// Keeps, of the thousands of misuses, the calls that no public header has.
class InnerMisuses {
 public:
  InnerMisuses()
      : before_(set_misuse_hook([](const Misuse& misuse) {
          const std::string call = misuse.call;
          if (!is_of_the_door(call)) all().insert(call);
        })) {
    all().clear();
  }
  ~InnerMisuses() { set_misuse_hook(before_); }
  InnerMisuses(const InnerMisuses&) = delete;
  InnerMisuses& operator=(const InnerMisuses&) = delete;

  static std::set<std::string>& all() {
    static std::set<std::string> calls;
    return calls;
  }

 private:
  static bool is_of_the_door(const std::string& call) {
    constexpr std::array classes{"Agent",      "Character", "Crowd",     "Lod",          "Machine",
                                 "ManyAgents", "Motion",    "Processes", "StateMachine", "StepPose"};
    constexpr std::array inner{"Agent::change", "Agent::change_process"};
    const std::string of = call.substr(0, call.find(':'));
    return std::ranges::count(classes, of) > 0 && std::ranges::count(inner, call) == 0;
  }

  MisuseHook before_;
};

void call_at_random(std::uint32_t seed, int calls) {
  api_test::RandomCalls random(api_test::mannequin(), seed);
  for (int call = 0; call < calls; ++call) {
    random.call();
    if (call % 16 != 0) continue;
    ASSERT_EQ(random.pose_all(), 0U) << "seed " << seed << ", call " << call;
  }
}

TEST(RandomCalls, NeitherCrashNorWriteWhatIsNoNumberAndAreNamedAsInTheHeaders) {
  const InnerMisuses inner;
  const char* const wanted = std::getenv("THRONG_RANDOM_SECONDS");
  const std::chrono::duration<double> seconds(wanted == nullptr ? 0.0 : std::atof(wanted));
  const auto start = std::chrono::steady_clock::now();
  std::uint32_t seed = 0;
  do {
    call_at_random(seed++, 1500);
    if (HasFatalFailure()) return;
  } while (seed < 4 || std::chrono::steady_clock::now() - start < seconds);
  EXPECT_THAT(InnerMisuses::all(), testing::IsEmpty());
  RecordProperty("seeds", static_cast<int>(seed));
}

}  // namespace
}  // namespace throng::random_calls_test
