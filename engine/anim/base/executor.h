#pragma once

namespace throng::anim {

/// A function and the context that it works on. Owns and allocates nothing.
struct Job {
  void (*run)(void* context, int index);
  void* context;
};

/// Runs jobs 0 to count - 1, each once, concurrently where it can. Returns when all are done and their stores are
/// visible to the caller. PuThreads is the default; a host's job system fits behind the same call.
class Executor {
 public:
  virtual ~Executor() = default;
  virtual void run(int count, Job job) = 0;
};

/// Runs one job after the other in the calling thread.
class InOrder final : public Executor {
 public:
  void run(int count, Job job) override {
    for (int index = 0; index < count; ++index) job.run(job.context, index);
  }
};

}  // namespace throng::anim
