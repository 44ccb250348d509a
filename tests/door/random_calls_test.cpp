// No order of calls and no number brings the library down, whatever the caller gets wrong.
//
//     THRONG_RANDOM_SECONDS=3600 build/release/tests/throng_door_tests --gtest_filter='RandomCalls.*'

#include "tests/door/random_calls.h"

#include <chrono>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/door/door_crowd.h"

namespace throng::random_calls_test {
namespace {

/// Hears of misuses and forgets them: there are thousands.
class DeafToMisuse {
 public:
  DeafToMisuse() : before_(set_misuse_hook([](const Misuse&) {})) {}
  ~DeafToMisuse() { set_misuse_hook(before_); }
  DeafToMisuse(const DeafToMisuse&) = delete;
  DeafToMisuse& operator=(const DeafToMisuse&) = delete;

 private:
  MisuseHook before_;
};

void call_at_random(std::uint32_t seed, int calls) {
  door_test::RandomCalls random(door_test::mannequin(), seed);
  for (int call = 0; call < calls; ++call) {
    random.call();
    if (call % 16 != 0) continue;
    ASSERT_EQ(random.pose_all(), 0U) << "seed " << seed << ", call " << call;
  }
}

TEST(RandomCalls, NeitherCrashNorWriteWhatIsNoNumber) {
  const DeafToMisuse deaf;
  const char* const wanted = std::getenv("THRONG_RANDOM_SECONDS");
  const std::chrono::duration<double> seconds(wanted == nullptr ? 0.0 : std::atof(wanted));
  const auto start = std::chrono::steady_clock::now();
  std::uint32_t seed = 0;
  do {
    call_at_random(seed++, 1500);
    if (HasFatalFailure()) return;
  } while (seed < 4 || std::chrono::steady_clock::now() - start < seconds);
  RecordProperty("seeds", static_cast<int>(seed));
}

}  // namespace
}  // namespace throng::random_calls_test
