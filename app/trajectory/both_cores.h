#pragma once

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace throng::app {

/// Returns how many threads help to read: as many as there are cores, at most four.
inline std::size_t reading_threads() { return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 4); }

/// Work on fewer rows is over before a thread has begun.
inline constexpr std::size_t rows_worth_a_thread = 20'000;

/// Calls work(0) in this thread and work(1), ... in others, and returns when all have returned. Where no thread can be
/// started, this one does their work.
template <typename Work>
void run_side_by_side(std::size_t count, Work work) {
  std::vector<std::thread> threads;
  std::size_t started = 1;
  try {
    threads.reserve(count);
    for (; started < count; ++started) threads.emplace_back(work, started);
  } catch (const std::system_error&) {  // this thread does the rest
  }
  work(std::size_t{0});
  for (std::size_t i = started; i < count; ++i) work(i);
  for (std::thread& thread : threads) thread.join();
}

}  // namespace throng::app
