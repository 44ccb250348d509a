#pragma once

namespace throng::render {

/// Runs parts of the renderer's work at once. The renderer starts no threads: a host's job system fits behind this, and
/// without one the calling thread does everything.
class JobRunner {
 public:
  virtual ~JobRunner() = default;

  /// Calls job(context, index) for each index below `count`, once each, on any threads. Returns when all are done and
  /// the caller sees their results.
  virtual void run(int count, void (*job)(void* context, int index), void* context) = 0;

  /// Returns how many jobs run at once, 1 or more. The renderer asks for no more of them.
  virtual int jobs_at_once() const = 0;
};

/// Calls visit(index) for each index below `count`: on `jobs`, or one after the other where it is null.
template <typename Visit>
void run_jobs(JobRunner* jobs, int count, Visit&& visit) {
  if (jobs == nullptr || count == 1) {
    for (int index = 0; index < count; ++index) visit(index);
    return;
  }
  jobs->run(
      count, [](void* context, int index) { (*static_cast<decltype(&visit)>(context))(index); }, &visit);
}

}  // namespace throng::render
