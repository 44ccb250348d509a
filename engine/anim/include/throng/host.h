#pragma once

#include <cstddef>

/// In place of the library a host may take misuses, run jobs, give memory, name threads and draw zones.
namespace throng {

/// A call that broke its contract: an id of nothing, a NaN, a call at the wrong time. The library
/// ignores such a call and leaves everything as it was.
struct Misuse {
  const char* call;    ///< the function, as "Agent::play"
  const char* reason;  ///< one sentence; both live as long as the hook is called
};

/// Hears of each misuse, on the thread that made the call. It does not call the library.
using MisuseHook = void (*)(const Misuse& misuse);

/// Sets the hook that hears of misuses, from any thread, and returns the hook before it. The first hook, which
/// nullptr sets again, prints one line for each call and reason. A build with assertions then ends the program.
MisuseHook set_misuse_hook(MisuseHook hook);

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

/// Gives and takes the large memory of the library: blocks of agents, local stores, streams of clips. Lists of
/// bookkeeping come from operator new, which a host may replace.
struct MemoryHooks {
  /// Returns `bytes` bytes, aligned to `alignment`, a power of two. It ends the program rather than return null. May be
  /// called from any thread.
  void* (*allocate)(std::size_t bytes, std::size_t alignment, void* context) = nullptr;
  /// Takes back what allocate() gave, with the same numbers.
  void (*release)(void* memory, std::size_t bytes, std::size_t alignment, void* context) = nullptr;
  void* context = nullptr;
};

/// Sets the functions that give memory from now on; without functions, operator new. Memory goes back to its giver,
/// so the functions stay callable. Call it when no other thread is in the library. One function without the other is
/// a misuse, which changes nothing.
void set_memory_hooks(const MemoryHooks& hooks);

/// Is called first on each thread that the library starts, with the number of its PU, from 1: to name it, or to choose
/// its core. PU 0 is the caller's own thread.
using ThreadHook = void (*)(int pu);

/// Sets the function that is told of new threads, from any thread; nullptr: none.
void set_thread_hook(ThreadHook hook);

/// Tells a profiler of zones: Tracy, Perfetto or any other. A zone is a stretch of a thread's time. Both functions are
/// called in pairs on that thread, from all PUs at once. Zones of a thread nest. A function does not call the library.
///
///     "Crowd::advance", "Crowd::update", "ManyAgents::reach", ...   a call, on the caller's thread
///       "schedule"                                                  PU 0 sorts agents and cuts tiles
///       "PU"                                                        all that a PU does in an update, on its thread
///         "fetch", "compute", "write back"                          of a tile; most copies are a part of "compute"
///       "ManyAgents::reach", ...                                    a PU's part of the requests, on its thread
struct ZoneHooks {
  /// Begins a zone on the calling thread, which works as this PU. The name lives as long as the program.
  void (*begin)(const char* name, int pu, void* context) = nullptr;
  /// Ends the newest zone of the calling thread.
  void (*end)(int pu, void* context) = nullptr;
  void* context = nullptr;
};

/// Sets the functions that hear of zones from now on; without functions, zones cost a load and a branch each. Call it
/// when no thread is in the library. One function without the other is a misuse, which changes nothing.
void set_zone_hooks(const ZoneHooks& hooks);

}  // namespace throng
