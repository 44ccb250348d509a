#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "throng/host.h"

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/run/pu_threads.h"
#include "tests/benchmark/programs/many_pus.h"

namespace throng::app {

/// Runs the jobs of a frame on threads, or records them: then it runs them one after the other on the calling thread
/// and times each. Frames have the same poses either way, because no job waits for another.
class FrameRecorder final : public Executor {
 public:
  explicit FrameRecorder(int threads) : threads_(threads) {}

  void run(int count, Job job) override;

  /// Runs a frame on threads. Returns its nanoseconds.
  double time(const std::function<void()>& frame);
  /// Runs a frame on this thread, and returns what each PU would have to do. `system` posed it. A round whose first job
  /// did nearly all the work was handed out in tiles of agents; that is how crowd logic shares out its work.
  SimulatedFrame record(const std::function<void()>& frame, const anim::AnimationSystem& system);

 private:
  using Clock = std::chrono::steady_clock;

  struct Recorded {
    Clock::time_point begin, end;
    std::vector<double> jobs_ns;
  };
  static SimulatedRound round_of_jobs(const Recorded& recorded, int agents);

  anim::PuThreads threads_;
  bool records_ = false;
  std::vector<Recorded> rounds_;
};

}  // namespace throng::app
