#include "engine/anim/run/pu_threads.h"

#include <cassert>
#include <chrono>
#include <memory>
#include <system_error>

#if !defined(_WIN32)
#include <unistd.h>
#endif

#include "engine/anim/base/sleep.h"
#include "engine/base/compiler.h"
#include "engine/base/files/cores.h"

namespace throng::anim {
namespace {

using Clock = std::chrono::steady_clock;

/// A thread waits awake a few times as long as sleeping and waking take on virtual cores, because a frame has many
/// rounds with short pauses in between.
constexpr std::chrono::microseconds waits_awake(200);

std::atomic<ThreadHook> thread_hook_of_the_host{nullptr};

/// Returns the number of this process: another one in a child of fork().
long own_process() {
#if defined(_WIN32)
  return 0;  // no process forks there
#else
  return getpid();
#endif
}

}  // namespace

PuThreads::PuThreads(int pus) : process_(own_process()), has_cores_(pus <= usable_cores()) {
  threads_.reserve(static_cast<std::size_t>(pus - 1));
  for (int pu = 1; pu < pus; ++pu) {
    if (!start(pu)) break;
  }
}

bool PuThreads::start(int pu) {
#if defined(__cpp_exceptions)
  try {
    threads_.emplace_back([this, pu] { work(pu); });
  } catch (const std::system_error&) {
    return false;
  }
#else
  threads_.emplace_back([this, pu] { work(pu); });  // ends the program if there are no more threads
#endif
  return true;
}

PuThreads::~PuThreads() {
  if (!are_here()) {
    // The handle of another process's thread can neither be joined nor destroyed.
    for (std::thread& thread : threads_) std::construct_at(&thread);
    return;
  }
  stopping_.store(true, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  wake_sleepers(round_);
  for (std::thread& thread : threads_) thread.join();
}

bool PuThreads::are_here() const { return threads_.empty() || process_ == own_process(); }

void PuThreads::run(int count, Job job) {
  assert(count >= 1 && static_cast<std::size_t>(count) <= threads_.size() + 1);
  if (count == 1 || !are_here()) {
    for (int number = 0; number < count; ++number) job.run(job.context, number);
    return;
  }
  job_ = job;
  count_ = count;
  running_.store(static_cast<std::uint32_t>(threads_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  wake_sleepers(round_);
  // If memory runs out here, the others still work on data that would be taken away.
  struct AllDone {
    ~AllDone() { threads.wait_for_all(); }
    const PuThreads& threads;
  } const all_done{*this};
  job.run(job.context, 0);
}

void PuThreads::wait_for_all() const {
  for (std::uint32_t left = running_.load(std::memory_order_acquire); left != 0;
       left = running_.load(std::memory_order_acquire)) {
    wait_while(running_, left);
  }
}

void PuThreads::wait_while(const std::atomic<std::uint32_t>& number, std::uint32_t is) const {
  constexpr int looks_at_a_time = 32;  // reading the clock takes longer than a look
  const Clock::time_point end = Clock::now() + waits_awake;
  while (has_cores_ && Clock::now() < end) {
    for (int look = 0; look < looks_at_a_time; ++look) {
      if (number.load(std::memory_order_acquire) != is) return;
      pause_in_loop();
    }
  }
  sleep_while(number, is);
}

void PuThreads::work(int pu) {
  if (const ThreadHook hook = thread_hook_of_the_host.load(); hook != nullptr) hook(pu);
  std::uint32_t seen = 0;
  while (true) {
    wait_while(round_, seen);
    seen = round_.load(std::memory_order_acquire);
    if (stopping_.load(std::memory_order_relaxed)) return;
    if (pu < count_) job_.run(job_.context, pu);
    if (running_.fetch_sub(1, std::memory_order_acq_rel) == 1) wake_sleepers(running_);
  }
}

}  // namespace throng::anim

void throng::set_thread_hook(ThreadHook hook) { anim::thread_hook_of_the_host.store(hook); }
