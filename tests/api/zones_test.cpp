// What the profiler of a host hears, and the trace that it reads.

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/api_crowd.h"

namespace throng::zones_test {
namespace {

using api_test::ApiCrowd;

constexpr int pus = 3;
constexpr std::uint32_t agents = 1000;

/// A profiler that notes the zones of each PU.
class Profiler {
 public:
  Profiler() { set_zone_hooks({.begin = begin, .end = end, .context = this}); }
  ~Profiler() { set_zone_hooks({}); }
  Profiler(const Profiler&) = delete;
  Profiler& operator=(const Profiler&) = delete;

  /// Returns the paths of all zones of a PU that have ended, as "Crowd::update/PU/compute".
  const std::vector<std::string>& ended(int pu) const { return ended_.at(static_cast<std::size_t>(pu)); }
  /// Returns whether all zones began and ended in pairs, each pair on one thread and for one PU.
  bool are_paired() const {
    return lonely_ends_ == 0 && std::ranges::all_of(open_, [](const auto& thread) { return thread.second.empty(); });
  }
  std::size_t count(int pu, const std::string& path) const {
    return static_cast<std::size_t>(std::ranges::count(ended(pu), path));
  }
  std::size_t count() const {
    std::size_t sum = 0;
    for (const std::vector<std::string>& paths : ended_) sum += paths.size();
    return sum;
  }

 private:
  struct Open {
    std::string path;
    int pu;
  };
  static void begin(const char* name, int pu, void* context) {
    auto* const profiler = static_cast<Profiler*>(context);
    const std::lock_guard lock(profiler->mutex_);
    std::vector<Open>& open = profiler->open_[std::this_thread::get_id()];
    open.push_back({.path = open.empty() ? name : open.back().path + "/" + name, .pu = pu});
  }
  static void end(int pu, void* context) {
    auto* const profiler = static_cast<Profiler*>(context);
    const std::lock_guard lock(profiler->mutex_);
    std::vector<Open>& open = profiler->open_[std::this_thread::get_id()];
    if (open.empty() || open.back().pu != pu) {
      ++profiler->lonely_ends_;
    } else {
      profiler->ended_.at(static_cast<std::size_t>(pu)).push_back(open.back().path);
      open.pop_back();
    }
  }

  std::mutex mutex_;
  std::map<std::thread::id, std::vector<Open>> open_;
  std::array<std::vector<std::string>, pus> ended_;
  int lonely_ends_ = 0;
};

/// Runs the last job first, in the calling thread. That PU finds all tiles.
class LastFirst final : public Executor {
 public:
  void run(int count, Job job) override {
    for (int index = count - 1; index >= 0; --index) job.run(job.context, index);
  }
};

/// A crowd that plays, and has been posed once.
ApiCrowd walking_crowd(CrowdOptions options = {}) {
  options.pus = pus;
  ApiCrowd crowd(agents, options);
  for (std::uint32_t agent = 0; agent < agents; ++agent) crowd.agent(agent).play({.clip = {agent % 3}});
  crowd.step();
  return crowd;
}

TEST(ApiZones, BeginAndEndInPairsOnEveryPu) {
  ApiCrowd crowd = walking_crowd();
  const Profiler profiler;
  crowd.step(3);
  EXPECT_TRUE(profiler.are_paired());
  for (int pu = 0; pu < pus; ++pu) EXPECT_FALSE(profiler.ended(pu).empty()) << pu;
}

TEST(ApiZones, NameThePuThatWorks) {
  LastFirst executor;
  ApiCrowd crowd = walking_crowd({.executor = &executor});
  const Profiler profiler;
  crowd.step();
  EXPECT_EQ(profiler.count(0, "Crowd::update/PU/compute"), 0U);
  EXPECT_GE(profiler.count(pus - 1, "Crowd::update/PU/compute"), agents / 32);
}

TEST(ApiZones, NestFromACallToThePartsOfATile) {
  ApiCrowd crowd = walking_crowd();
  const Profiler profiler;
  crowd.step();
  EXPECT_EQ(profiler.ended(0).front(), "Crowd::advance");
  EXPECT_EQ(profiler.ended(0).at(1), "Crowd::update/schedule");
  EXPECT_EQ(profiler.ended(0).back(), "Crowd::update");
  EXPECT_EQ(profiler.count(0, "Crowd::update/PU"), 1U);
  std::size_t tiles = 0;
  for (int pu = 0; pu < pus; ++pu) {
    const std::string unit = pu == 0 ? "Crowd::update/PU" : "PU";
    EXPECT_LE(profiler.count(pu, unit + "/fetch"), 1U) << "later tiles come in while one is computed";
    EXPECT_EQ(profiler.count(pu, unit + "/fetch"), profiler.count(pu, unit + "/write back"));
    tiles += profiler.count(pu, unit + "/compute");
  }
  EXPECT_GE(tiles, agents / 32) << "a tile has at most 32 agents";
  EXPECT_LT(tiles, agents / 4) << "a zone is a tile, not an agent";
}

TEST(ApiZones, OfRequestsToManyAgentsAreOnEveryPu) {
  ApiCrowd crowd = walking_crowd();
  std::vector<SpeedRequest> speeds;
  for (const AgentId agent : crowd->agents()) speeds.push_back({.agent = agent, .speed = 1.5F});
  std::vector<RootMotion> motions(agents);
  const Profiler profiler;
  EXPECT_TRUE(crowd->many().set_speeds(speeds));
  EXPECT_TRUE(crowd->many().displacements(crowd->clock(), crowd->clock(), crowd->agents(), motions));
  for (int pu = 0; pu < pus; ++pu) {
    const std::string call = pu == 0 ? "ManyAgents::set_speeds/" : "";
    EXPECT_EQ(profiler.count(pu, call + "ManyAgents::set_speeds"), 1U) << pu;
    EXPECT_EQ(profiler.count(pu, "ManyAgents::displacements"), 1U) << pu;
  }
  EXPECT_TRUE(profiler.are_paired());
}

TEST(ApiZones, OfACallThatIsRefusedEndToo) {
  ApiCrowd crowd = walking_crowd();
  const MisuseHook before = set_misuse_hook([](const Misuse&) {});
  const Profiler profiler;
  crowd->advance(Ticks{-1});
  crowd->update({});
  set_misuse_hook(before);
  EXPECT_TRUE(profiler.are_paired());
  EXPECT_EQ(profiler.count(0, "Crowd::advance"), 1U);
  EXPECT_EQ(profiler.count(0, "Crowd::update"), 1U);
}

TEST(ApiZones, AreNotToldOnceTheHooksAreUnset) {
  ApiCrowd crowd = walking_crowd();
  const Profiler profiler;
  crowd.step();
  const std::size_t told = profiler.count();
  set_zone_hooks({});
  crowd.step();
  EXPECT_GT(told, 0U);
  EXPECT_EQ(profiler.count(), told);
}

TEST(ApiZones, ChangeNoPose) {
  ApiCrowd watched = walking_crowd(), alone = walking_crowd();
  {
    const Profiler profiler;
    watched.step(3);
  }
  alone.step(3);
  EXPECT_EQ(watched.hash(), alone.hash());
}

TEST(ApiZones, NeedBothFunctions) {
  static int refused;
  refused = 0;
  const MisuseHook before = set_misuse_hook([](const Misuse&) { ++refused; });
  {
    const Profiler profiler;
    set_zone_hooks({.begin = [](const char*, int, void*) {}});
    walking_crowd();
    EXPECT_GT(profiler.count(), 0U) << "the hooks of before stay";
  }
  set_misuse_hook(before);
  EXPECT_EQ(refused, 1);
}

std::int64_t now() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

TEST(ApiTrace, ListsWhatEachPuDidInOrderWithinTheUpdate) {
  ApiCrowd crowd = walking_crowd({.trace = true});
  const std::int64_t before = now();
  crowd.step();
  const std::int64_t after = now();
  std::uint32_t posed = 0;
  for (int pu = 0; pu < pus; ++pu) {
    const std::vector<PuSpan> spans = crowd->debug().trace(pu);
    ASSERT_FALSE(spans.empty()) << pu;
    EXPECT_GE(spans.front().begin, before);
    EXPECT_LE(spans.back().end, after);
    EXPECT_STREQ(spans.back().name, "wait") << "for the slowest PU";
    std::int64_t last = spans.front().begin;
    for (const PuSpan& span : spans) {
      EXPECT_EQ(span.begin, last);
      EXPECT_GE(span.end, span.begin);
      last = span.end;
      if (span.name == std::string("compute")) posed += span.agents;
    }
  }
  EXPECT_EQ(posed, agents);
}

TEST(ApiTrace, BeginsWithTheScheduleOfPu0) {
  ApiCrowd crowd = walking_crowd({.trace = true});
  EXPECT_STREQ(crowd->debug().trace(0).front().name, "schedule");
  EXPECT_STREQ(crowd->debug().trace(1).front().name, "wait") << "to be woken";
}

TEST(ApiTrace, IsEmptyWithoutTheOptionAndOfAPuThatThereIsNot) {
  ApiCrowd crowd = walking_crowd();
  EXPECT_TRUE(crowd->debug().trace(0).empty());
  EXPECT_TRUE(crowd->configure({.pus = pus, .trace = true}));
  crowd.step();
  EXPECT_FALSE(crowd->debug().trace(pus - 1).empty());
  EXPECT_TRUE(crowd->debug().trace(pus).empty());
  EXPECT_TRUE(crowd->debug().trace(-1).empty());
}

}  // namespace
}  // namespace throng::zones_test
