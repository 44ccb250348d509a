#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <queue>
#include <thread>
#include <vector>

#include "throng/host.h"

namespace throng::anim {

/// A small job system as a game has it: some threads, and jobs for the one that is free.
class HostJobs {
 public:
  explicit HostJobs(int threads) {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
  }

  void submit(std::function<void()> job) {
    const std::scoped_lock lock(mutex_);
    jobs_.push(std::move(job));
    ++unfinished_;
    submitted_.notify_one();
  }

  void wait_for_all() {
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [this] { return unfinished_ == 0; });
  }

 private:
  void work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (submitted_.wait(lock, stop, [this] { return !jobs_.empty(); })) {
      const std::function<void()> job = std::move(jobs_.front());
      jobs_.pop();
      lock.unlock();
      job();
      lock.lock();
      if (--unfinished_ == 0) finished_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable_any submitted_;
  std::condition_variable finished_;
  std::queue<std::function<void()>> jobs_;
  int unfinished_ = 0;
  std::vector<std::jthread> threads_;  // last: they end before what they use
};

/// Runs the PUs on such a job system. No more than this is needed.
class HostExecutor final : public Executor {
 public:
  explicit HostExecutor(HostJobs& jobs) : jobs_(jobs) {}

  void run(int count, Job job) override {
    for (int index = 0; index < count; ++index) {
      jobs_.submit([job, index] { job.run(job.context, index); });
    }
    jobs_.wait_for_all();
  }

 private:
  HostJobs& jobs_;
};

}  // namespace throng::anim
