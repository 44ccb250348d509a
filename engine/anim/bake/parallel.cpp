#include "engine/anim/bake/parallel.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/base/files/cores.h"

namespace throng::anim {

namespace {

/// Starts a helper. Returns an invalid future if the machine has no more threads.
template <typename Work>
std::future<void> start_helper(const Work& work) {
#if defined(__cpp_exceptions)
  try {
    return std::async(std::launch::async, work);
  } catch (const std::system_error&) {
    return {};
  }
#else
  return std::async(std::launch::async, work);  // ends the program if there are no more threads
#endif
}

}  // namespace

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  const std::size_t threads = std::min(count, static_cast<std::size_t>(usable_cores()));
  std::vector<std::future<void>> helpers;
  while (helpers.size() + 1 < threads) {
    std::future<void> helper = start_helper(take);
    if (!helper.valid()) break;  // the threads that began do all of it
    helpers.push_back(std::move(helper));
  }
  take();
  for (std::future<void>& helper : helpers) helper.get();
}

}  // namespace throng::anim
