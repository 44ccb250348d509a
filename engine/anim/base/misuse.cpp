#include "engine/anim/base/misuse.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <utility>

namespace throng::anim {
namespace {

std::atomic<MisuseHook> hook_of_the_host{nullptr};
thread_local MisuseListener* listener = nullptr;
thread_local bool is_in_hook = false;

/// Returns whether this was not told before. Of very many it tells the first alone.
bool is_new(const Misuse& misuse) {
  static std::array<std::atomic<std::size_t>, 256> told{};
  const std::size_t hash = std::hash<std::string>{}(std::string(misuse.call) + misuse.reason) | 1U;
  for (std::atomic<std::size_t>& one : told) {
    std::size_t seen = 0;
    if (one.compare_exchange_strong(seen, hash)) return true;
    if (seen == hash) return false;
  }
  return false;
}

void print_once(const Misuse& misuse) {
  if (is_new(misuse)) std::fprintf(stderr, "throng: %s: %s\n", misuse.call, misuse.reason);
#ifndef NDEBUG
  std::abort();
#endif
}

}  // namespace

MisuseListener::MisuseListener() : before_(std::exchange(listener, this)) {}
MisuseListener::~MisuseListener() { listener = before_; }

void MisuseListener::hear(const Misuse& misuse) {
  if (reason_.empty()) reason_ = misuse.reason;
  if (before_ != nullptr) before_->hear(misuse);
}

bool report_misuse(const Misuse& misuse) {
  if (listener != nullptr) listener->hear(misuse);
  if (std::exchange(is_in_hook, true)) return false;  // a hook that misuses the library is not told of it
  const MisuseHook hook = hook_of_the_host.load();
  (hook == nullptr ? print_once : hook)(misuse);
  is_in_hook = false;
  return false;
}

Error refuse(const Misuse& misuse) {
  report_misuse(misuse);
  return Error{std::string(misuse.call) + ": " + misuse.reason};
}

}  // namespace throng::anim

throng::MisuseHook throng::set_misuse_hook(MisuseHook hook) { return anim::hook_of_the_host.exchange(hook); }
