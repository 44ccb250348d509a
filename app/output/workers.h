#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/result.h"

namespace throng::app {

/// Does jobs on threads of its own, so that drawing goes on meanwhile. One thread does them in the order in which they
/// came. add() waits while as many jobs wait as may.
class Workers {
 public:
  using Job = std::function<Status()>;

  Workers(int threads, std::size_t most_waiting);
  /// Leaves out the jobs that have not begun.
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Adds a job. Errors: the error of the first job that failed; from then on none is done.
  Status add(Job job);
  /// Waits until all jobs are done. Errors: the error of the first job that failed.
  Status finish();

 private:
  void work();
  static Status done(const Job& job);

  std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> waiting_;
  std::size_t at_work_ = 0;  // jobs that have begun and not ended
  bool ends_ = false;
  Status outcome_ = Done{};
  std::vector<std::thread> threads_;  // last, as they use all of it
};

}  // namespace throng::app
