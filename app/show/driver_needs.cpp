#include "app/show/driver_needs.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <latch>
#include <system_error>
#include <thread>
#include <vector>

#include "app/files/memory_check.h"
#include "engine/anim/base/cores.h"
#include "engine/base/files/free_memory.h"
#include "engine/base/files/process.h"
#include "engine/base/text/size_text.h"

namespace throng::app {
namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

/// Mesa's llvmpipe touches this much before its first picture.
constexpr std::uint64_t bytes_of_driver = 192 * mebibyte;

/// llvmpipe starts no more threads than this to shade.
constexpr int most_driver_threads = 16;

/// Mesa's llvmpipe reserves this much: its libraries, and a stack and a heap for each thread.
std::uint64_t address_space_of_driver() {
  constexpr std::uint64_t libraries = 900 * mebibyte, thread = 150 * mebibyte;
  return libraries + static_cast<std::uint64_t>(std::min(anim::usable_cores(), most_driver_threads)) * thread;
}

/// Returns whether so many threads run at once.
bool run_at_once(int threads) {
  std::latch all_tried(1);
  std::vector<std::jthread> started;  // after what they wait for: they are joined first
  bool could = true;
  try {
    while (static_cast<int>(started.size()) < threads) started.emplace_back([&] { all_tried.wait(); });
  } catch (const std::system_error&) {
    could = false;
  }
  all_tried.count_down();
  return could;
}

}  // namespace

anim::Status check_room_to_draw() {
  const std::uint64_t reserved = address_space_of_driver(), left = free_address_space();
  if (reserved > left) {
    return anim::Error{"drawing needs " + size_text(reserved) + " of address space, but " + size_text(left) +
                       " are left; raise the limit (ulimit -v)"};
  }
  return check_memory("drivers of OpenGL", bytes_of_driver, "close other programs");
}

void spare_driver_threads() {
  constexpr int for_each_core = 3, others = 2;  // to shade, to compute, and a PU; to compile and to write a cache
  if (std::getenv("LP_NUM_THREADS") != nullptr) return;
  if (run_at_once(for_each_core * std::min(anim::usable_cores(), most_driver_threads) + others)) return;
  set_variable("LP_NUM_THREADS", "0");
}

}  // namespace throng::app
