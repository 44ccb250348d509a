#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "throng/host.h"

namespace throng::anim {

/// Runs each PU on a thread. The calling thread is PU 0; the others are created once and wait between jobs. If there is
/// a core for each, a thread that waits spins for about as long as a wake-up takes, then sleeps.
/// They stay in the process that started them: in a child of fork() the object runs jobs in order, and can be
/// destroyed.
class PuThreads final : public Executor {
 public:
  /// Starts a thread for each PU but the first, or as many as the system has left.
  explicit PuThreads(int pus);
  ~PuThreads() override;
  PuThreads(const PuThreads&) = delete;
  PuThreads& operator=(const PuThreads&) = delete;

  /// Runs job i on PU i. `count` is at most the number of PUs. An exception of a job on the calling thread, for want
  /// of memory, is passed on once all jobs have ended; on another thread it ends the program.
  void run(int count, Job job) override;
  /// Returns whether this process has the threads.
  bool are_here() const;
  /// Returns how many PUs there are: fewer than requested where the system had no more threads.
  int pus() const { return static_cast<int>(threads_.size()) + 1; }

 private:
  bool start(int pu);
  void work(int pu);
  void wait_for_all() const;
  void wait_while(const std::atomic<std::uint32_t>& number, std::uint32_t is) const;

  std::vector<std::thread> threads_;
  long process_;    // the number of the process that has the threads
  bool has_cores_;  // there is a core for each PU
  Job job_{};
  int count_ = 0;
  std::atomic<std::uint32_t> round_{0};  // a new value wakes the threads
  std::atomic<std::uint32_t> running_{0};
  std::atomic<bool> stopping_{false};
};

}  // namespace throng::anim
