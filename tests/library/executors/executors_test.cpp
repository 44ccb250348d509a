// Who runs the jobs of the PUs: our own threads, or a host's job system.
#include <atomic>
#include <chrono>
#include <new>
#include <thread>

#include <gtest/gtest.h>

#include "engine/anim/run/pu_threads.h"
#include "tests/library/crowd_hash.h"
#include "tests/library/executor_promises.h"
#include "tests/library/executors/host_jobs.h"

namespace throng::anim::executors_test {
namespace {

TEST(Executors, PuThreadsThatRunOutOfMemoryHaveNoJobLeftAtWork) {
  PuThreads threads(2);
  std::atomic<bool> ended = false;
  const auto job = [](void* ended_of_the_other, int index) {
    if (index == 0) throw std::bad_alloc();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    *static_cast<std::atomic<bool>*>(ended_of_the_other) = true;
  };
  EXPECT_THROW(threads.run(2, {job, &ended}), std::bad_alloc);
  EXPECT_TRUE(ended);
}

TEST(Executors, PuThreadsRunEachJobOnce) {
  PuThreads threads(4);
  for (const int jobs : {1, 2, 4}) expect_each_job_once(threads, jobs);
}

TEST(Executors, AHostsJobSystemRunsEachJobOnce) {
  HostJobs host(2);
  HostExecutor executor(host);
  for (const int jobs : {1, 2, 16}) expect_each_job_once(executor, jobs);
}

TEST(Executors, AHostsJobSystemGivesThePosesOfOurOwnThreads) {
  HostJobs host(2);
  HostExecutor executor(host);
  expect_the_poses_of_our_own_threads(executor);
}

}  // namespace
}  // namespace throng::anim::executors_test
