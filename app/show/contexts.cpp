#include "app/show/contexts.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <latch>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "app/files/memory_check.h"
#include "engine/base/files/cores.h"
#include "engine/base/files/free_memory.h"
#include "engine/base/files/process.h"
#include "engine/base/result.h"
#include "engine/base/text/size_text.h"

namespace throng::app {
namespace {

using Maker = std::function<MadeContext()>;

/// A context that could be had instead of one that does not open.
struct Alternative {
  const Maker& make;
  const char* advice;
};

bool wants_pictures(const DemoOptions& options) { return drawn_frames(options) != DrawWhich::none || options.ui; }

std::string last_resort(const DemoOptions& options) {
  return wants_pictures(options) ? "" : "; --headless=none runs without drawing";
}

/// Gives the error of the requested context, with an alternative that works, or else with the errors of all.
MadeContext refuse(std::string reasons, std::span<const Alternative> alternatives, const DemoOptions& options) {
  for (const Alternative& other : alternatives) {
    const MadeContext made = other.make();
    if (made) return Error{reasons + "; use " + other.advice};
    reasons += "; " + made.error().message;
  }
  return Error{reasons + last_resort(options)};
}

MadeContext open_or_refuse(const Maker& make, std::span<const Alternative> alternatives, const DemoOptions& options) {
  MadeContext made = make();
  return made ? std::move(made) : refuse(made.error().message, alternatives, options);
}

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

/// Mesa's llvmpipe touches this much before its first picture.
constexpr std::uint64_t bytes_of_driver = 192 * mebibyte;

/// llvmpipe starts no more threads than this to shade.
constexpr int most_driver_threads = 16;

/// Mesa's llvmpipe reserves this much: its libraries, and a stack and a heap for each thread.
std::uint64_t address_space_of_driver() {
  constexpr std::uint64_t libraries = 900 * mebibyte, thread = 150 * mebibyte;
  return libraries + static_cast<std::uint64_t>(std::min(usable_cores(), most_driver_threads)) * thread;
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

/// Checks that an OpenGL driver can have the memory and the address space that it takes before it draws anything.
/// Software renderers crash without them, far from any code of ours. The error says what is missing.
Status check_room_to_draw() {
  const std::uint64_t reserved = address_space_of_driver(), left = free_address_space();
  if (reserved > left) {
    return Error{"drawing needs " + size_text(reserved) + " of address space, but " + size_text(left) +
                 " are left; raise the limit (ulimit -v)"};
  }
  return check_memory("drivers of OpenGL", bytes_of_driver, "close other programs");
}

/// Tells Mesa's software renderer to draw on the thread that calls it where the system starts no more threads, because
/// it would wait forever for the threads that it did not get. Does nothing where LP_NUM_THREADS is set already. Call it
/// before a context is opened, on the only thread that reads or writes the environment.
void spare_driver_threads() {
  constexpr int for_each_core = 3, others = 2;  // to shade, to compute, and a PU; to compile and to write a cache
  if (std::getenv("LP_NUM_THREADS") != nullptr) return;
  if (run_at_once(for_each_core * std::min(usable_cores(), most_driver_threads) + others)) return;
  set_variable("LP_NUM_THREADS", "0");
}

}  // namespace

ContextMakers context_makers(const DemoOptions& options) {
  using namespace render::gl;
  const WindowOptions window{.width = options.width, .height = options.height};
  const EglOptions egl{.force_software = options.force_software};
  return {[window] { return make_window_context(window); }, [egl] { return make_egl_context(egl); },
          make_osmesa_context};
}

MadeContext open_context(const DemoOptions& options, const ContextMakers& makers) {
  if (const Status fits = check_room_to_draw(); !fits) {
    return Error{fits.error().message + last_resort(options)};
  }
  spare_driver_threads();
  const auto refuse_unless = [&](const Maker& make, const std::vector<Alternative>& alternatives) {
    return open_or_refuse(make, alternatives, options);
  };
  switch (options.context) {
    case ContextKind::window:
      return refuse_unless(makers.window, {{makers.egl, "--headless"}, {makers.osmesa, "--headless"}});
    case ContextKind::egl:
      return refuse_unless(makers.egl, {{makers.osmesa, "--headless=osmesa"}});
    case ContextKind::osmesa:
      return refuse_unless(makers.osmesa, {{makers.egl, "--headless=egl"}});
    default:
      break;
  }
  MadeContext first = makers.egl();
  if (first) return first;
  MadeContext second = makers.osmesa();
  return second ? std::move(second) : refuse(first.error().message + "; " + second.error().message, {}, options);
}

}  // namespace throng::app
