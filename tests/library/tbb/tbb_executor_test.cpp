// oneTBB as the job system that runs the PUs.

#include "engine/anim/run/tbb_executor.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "tests/library/crowd_hash.h"
#include "tests/library/executor_promises.h"

namespace throng::anim::tbb_executor_test {
namespace {

TEST(TbbExecutor, RunsEachJobOnce) {
  tbb::task_arena arena(2);
  TbbExecutor executor(arena);
  for (const int jobs : {1, 2}) expect_each_job_once(executor, jobs);
}

TEST(TbbExecutor, RunsMoreJobsThanItsArenaHasThreads) {
  for (const int threads : {1, 2}) {
    tbb::task_arena arena(threads);
    TbbExecutor executor(arena);
    for (const int jobs : {3, 16, 256}) expect_each_job_once(executor, jobs);
  }
}

TEST(TbbExecutor, RunsFromInsideAJobOfTheHost) {
  tbb::task_arena arena(2);
  TbbExecutor executor(arena);
  arena.execute([&executor] { expect_each_job_once(executor, 8); });
}

/// Two jobs that meet. Then the caller submits work of the host and is done, and the other lingers for it: whoever
/// waits for the jobs is free to take that work.
struct Meeting {
  tbb::task_arena arena{2};
  std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> arrived{0};
  bool submitted = false;
  std::atomic<bool> host_work_done{false};
  std::thread::id host_worker;

  void attend() {
    ++arrived;
    linger_until([this] { return arrived == 2; });
    if (std::this_thread::get_id() == caller) {
      if (arrived == 2) submit_host_work();
    } else {
      linger_until([this] { return host_work_done.load(); });
    }
  }

  void submit_host_work() {
    submitted = true;
    arena.enqueue([this] {
      host_worker = std::this_thread::get_id();
      host_work_done = true;
    });
  }

  static void linger_until(auto condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
    while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  }
};

TEST(TbbExecutor, TakesNoWorkOfTheHostWhileItWaits) {
  Meeting meeting;
  TbbExecutor executor(meeting.arena);
  executor.run(2, {[](void* context, int) { static_cast<Meeting*>(context)->attend(); }, &meeting});
  while (meeting.submitted && !meeting.host_work_done) std::this_thread::yield();
  EXPECT_NE(meeting.host_worker, meeting.caller);
}

TEST(TbbExecutor, GivesThePosesOfOurOwnThreads) {
  for (const int threads : {1, 2}) {
    tbb::task_arena arena(threads);
    TbbExecutor executor(arena);
    expect_the_poses_of_our_own_threads(executor);
  }
}

}  // namespace
}  // namespace throng::anim::tbb_executor_test
