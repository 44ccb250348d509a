// Agents and characters come and go for minutes of a game, and the crowd takes no more memory than before.
//
//     THRONG_LIFE_FRAMES=36000 build/release/tests/throng_api_tests --gtest_filter='ApiLife.*'

#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "engine/base/compiler.h"
#include "tests/api/api_crowd.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::life_test {
namespace {

using api_test::mannequin;

/// Returns the megabytes of the program that lie in memory; 0 where the system does not tell, or where a sanitizer
/// keeps what was freed.
double resident_megabytes() {
#if defined(THRONG_HAS_ADDRESS_SANITIZER)
  return 0.0;
#endif
  std::ifstream told("/proc/self/statm");
  double pages = 0.0, resident = 0.0;
  return told >> pages >> resident ? resident * 4096.0 / 1e6 : 0.0;
}

/// A crowd in which the oldest agents make room for new ones, frame by frame.
class Stream {
 public:
  explicit Stream(std::size_t room) {
    requests_.reserve(room);
    living_.reserve(room);
  }

  /// Replaces `count` agents of the crowd's characters, and poses those that are there.
  void frame(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) crowd_.remove_agent(living_[i]);
    for (std::uint32_t i = 0; i < count; ++i) living_[i] = join();
    pose();
  }
  void fill(std::uint32_t count) {
    while (living_.size() < count) living_.push_back(join());
    pose();
  }
  /// Lets a character join, who brings an agent, and leave again.
  void visit(const Character& guest) {
    const auto id = crowd_.add(guest);
    ASSERT_TRUE(id) << id.error().message;
    const AgentId agent = crowd_.add_agent(*id);
    crowd_.agent(agent).play({.clip = {1}});
    pose();
    crowd_.remove_agent(agent);
    const Status left = crowd_.remove(*id);
    ASSERT_TRUE(left) << left.error().message;
  }
  std::uint64_t joined() const { return joined_; }

 private:
  AgentId join() {
    const AgentId agent = crowd_.add_agent();
    crowd_.agent(agent).play({.clip = {static_cast<std::uint32_t>(joined_++ % 7)}});
    return agent;
  }
  void pose() {
    requests_.clear();
    for (const AgentId agent : living_) requests_.push_back({.agent = agent});
    crowd_.advance(ticks_per_second / 60);
    crowd_.update(requests_);
  }

  Crowd crowd_ = std::move(*Crowd::create(mannequin()));
  std::vector<AgentId> living_;
  std::vector<PoseRequest> requests_;
  std::uint64_t joined_ = 0;
};

TEST(ApiLife, AFrameThatReplacesAThousandAllocatesNothingAfterTheFirst) {
  Stream stream(2000);
  stream.fill(1000);
  for (int frame = 0; frame < 3; ++frame) stream.frame(1000);
  const HotPathCounts before = hot_path_counts();
  for (int frame = 0; frame < 5; ++frame) stream.frame(1000);
  EXPECT_EQ((hot_path_counts() - before).allocations, 0U);
}

TEST(ApiLife, MinutesOfComingAndGoingGrowNothing) {
  const char* const wanted = std::getenv("THRONG_LIFE_FRAMES");
  const int frames = wanted == nullptr ? 3600 : std::atoi(wanted);
  constexpr int frames_a_character = 360;
  Stream stream(400);
  stream.fill(200);
  double after_a_tenth = 0.0;
  for (int frame = 0; frame < frames; ++frame) {
    stream.frame(11);
    if (frame % frames_a_character == 0)
      stream.visit(load(THRONG_SOURCE_DIR "/assets/mannequin.glb")->characters.front());
    if (frame == frames / 10) after_a_tenth = resident_megabytes();
  }
  EXPECT_GE(stream.joined(), static_cast<std::uint64_t>(frames) * 11U);
  // Bakes of the same file on another number of threads leave the heap a little different each time.
  EXPECT_LT(resident_megabytes(), after_a_tenth + 8.0);
}

}  // namespace
}  // namespace throng::life_test
