// What a host in C does in the library's place, and what it learns of its crowd.

#include <atomic>
#include <cstdlib>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"

namespace throng::c_host_test {
namespace {

using api_test::CCrowd;
using api_test::first_character;

/// Runs each job on a thread of its own, and counts them.
void run_on_threads(int count, throng_job job, void* context, void* user) {
  *static_cast<int*>(user) += count;
  std::vector<std::thread> threads;
  for (int index = 0; index < count; ++index) threads.emplace_back(job, context, index);
  for (std::thread& thread : threads) thread.join();
}

TEST(ApiCHost, RunsThePusOnItsOwnThreads) {
  int jobs = 0;
  throng_crowd_options options = throng_crowd_options_default();
  options.pus = 3;
  options.executor = run_on_threads;
  options.executor_user = &jobs;
  const CCrowd hosted(100, options), own(100);
  for (std::uint32_t agent = 0; agent < 100; ++agent) {
    hosted.play(agent, agent % 7);
    own.play(agent, agent % 7);
  }
  hosted.step(3);
  own.step(3);
  EXPECT_GT(jobs, 0);
  EXPECT_EQ(hosted.hash(), own.hash());
  const int before = jobs;
  throng_crowd_options alone = throng_crowd_options_default();
  alone.hash = 1;
  EXPECT_EQ(throng_crowd_configure(hosted.crowd, &alone), 0);
  hosted.step(3);
  own.step(3);
  EXPECT_EQ(jobs, before) << "it was configured anew";
  EXPECT_EQ(hosted.hash(), own.hash());
  alone.pus = 100'000;
  EXPECT_NE(throng_crowd_configure(hosted.crowd, &alone), 0);
  alone = throng_crowd_options_default();
  alone.palettes = 5;
  EXPECT_NE(throng_crowd_configure(hosted.crowd, &alone), 0);
}

/// Counts bytes. Loading bakes on several threads, which all ask the host for memory.
struct Account {
  std::atomic<std::size_t> given = 0;
  std::atomic<std::size_t> taken = 0;
};

TEST(ApiCHost, GivesTheMemoryOfBlocksAndTakesItBack) {
  Account account;
  const auto allocate = [](std::size_t bytes, std::size_t alignment, void* user) {
    static_cast<Account*>(user)->given += bytes;
    return std::aligned_alloc(alignment, bytes);
  };
  const auto release = [](void* memory, std::size_t bytes, std::size_t, void* user) {
    static_cast<Account*>(user)->taken += bytes;
    std::free(memory);
  };
  ASSERT_EQ(throng_set_memory_hooks(allocate, release, &account), 0);
  {
    const CCrowd crowd(1000);
    EXPECT_EQ(throng_set_memory_hooks(nullptr, nullptr, nullptr), 0);
    EXPECT_NE(throng_set_memory_hooks(allocate, nullptr, nullptr), 0) << "one without the other";
    EXPECT_GT(account.given.load(), std::size_t{100'000});
  }
  EXPECT_EQ(account.taken.load(), account.given.load());
}

TEST(ApiCHost, IsToldOfEachThread) {
  std::atomic<int> told{0};
  throng_set_thread_hook([](int pu, void* user) { *static_cast<std::atomic<int>*>(user) += pu; }, &told);
  {
    throng_crowd_options options = throng_crowd_options_default();
    options.pus = 4;
    const CCrowd crowd(1, options);
    crowd.play(0, 0);
    crowd.step();
  }
  throng_set_thread_hook(nullptr, nullptr);
  EXPECT_EQ(told, 1 + 2 + 3);
}

TEST(ApiCHost, HearsOfZonesInPairs) {
  std::atomic<int> open{0}, began{0};
  struct Counts {
    std::atomic<int>&open, &began;
  } counts{open, began};
  const auto begin = [](const char*, int, void* user) {
    ++static_cast<Counts*>(user)->open;
    ++static_cast<Counts*>(user)->began;
  };
  const auto end = [](int, void* user) { --static_cast<Counts*>(user)->open; };
  const CCrowd crowd(100);
  for (std::uint32_t agent = 0; agent < 100; ++agent) crowd.play(agent, 0);
  EXPECT_EQ(throng_set_zone_hooks(begin, end, &counts), 0);
  crowd.step();
  EXPECT_NE(throng_set_zone_hooks(begin, nullptr, nullptr), 0) << "one without the other";
  EXPECT_EQ(throng_set_zone_hooks(nullptr, nullptr, nullptr), 0);
  EXPECT_GT(began, 0);
  EXPECT_EQ(open, 0);
}

TEST(ApiCHost, ReadsWhatAPuDid) {
  throng_crowd_options options = throng_crowd_options_default();
  options.trace = 1;
  const CCrowd crowd(100, options);
  for (std::uint32_t agent = 0; agent < 100; ++agent) crowd.play(agent, 0);
  crowd.step();
  std::vector<throng_pu_span> spans(throng_crowd_trace(crowd.crowd, 0, nullptr, 0));
  ASSERT_GE(spans.size(), 3U);
  spans.resize(2);
  EXPECT_GE(throng_crowd_trace(crowd.crowd, 0, spans.data(), 2), 3U) << "it says how many there are";
  EXPECT_STREQ(spans[0].name, "schedule");
  EXPECT_EQ(spans[0].end, spans[1].begin);
  EXPECT_EQ(throng_crowd_trace(crowd.crowd, 9, nullptr, 0), 0U) << "there is no such PU";
}

TEST(ApiCHost, LearnsWhoIsThereAndWhatAnUpdateTook) {
  const CCrowd c(3);
  for (std::uint32_t agent = 0; agent < 3; ++agent) c.play(agent, 1);
  c.step(2);
  EXPECT_EQ(throng_crowd_remove_agent(c.crowd, c.ids[1]), 0);
  throng_id there[4];
  ASSERT_EQ(throng_crowd_agents(c.crowd, there, 1), 2U) << "it says how many there are";
  throng_crowd_agents(c.crowd, there, 4);
  EXPECT_EQ(there[1].number, c.ids[2].number);
  EXPECT_EQ(throng_crowd_number_limit(c.crowd), 3U);
  EXPECT_EQ(throng_agent_exists(c.crowd, c.ids[1]), 0);
  EXPECT_EQ(throng_agent_character(c.crowd, c.ids[2]).number, 0U);
  EXPECT_EQ(throng_agent_character(c.crowd, c.ids[1]).number, THRONG_NONE);
  EXPECT_EQ(throng_crowd_posed_agents(c.crowd), 3U);
  EXPECT_GT(throng_crowd_predicted_nanoseconds(c.crowd), 0.0);
  EXPECT_GT(throng_crowd_update_milliseconds(c.crowd), 0.0);
  EXPECT_GT(throng_crowd_bytes_per_agent(c.crowd), 0.0);
  EXPECT_STRNE(throng_crowd_kernels(c.crowd), "");
  const throng_id second = throng_crowd_add_character(c.crowd, c.character);
  EXPECT_EQ(second.number, 1U);
  EXPECT_EQ(throng_crowd_remove_character(c.crowd, second), 0);
  EXPECT_EQ(throng_crowd_character(c.crowd, second), nullptr);
}

}  // namespace
}  // namespace throng::c_host_test
