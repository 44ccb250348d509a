#include <mutex>

#include "engine/anim/api/c/parts.h"

namespace throng::c {
namespace {

/// A function of the host and its `user`, which any thread may set and call.
template <typename Function>
class HostHook {
 public:
  void set(Function function, void* user) {
    const std::lock_guard lock(mutex_);
    function_ = function;
    user_ = user;
  }
  void call(auto... arguments) {
    std::unique_lock lock(mutex_);
    const Function function = function_;
    void* const user = user_;
    lock.unlock();  // the host may set another meanwhile
    if (function != nullptr) function(arguments..., user);
  }

 private:
  std::mutex mutex_;
  Function function_ = nullptr;
  void* user_ = nullptr;
};

HostHook<throng_misuse_hook>& misuse_hook() {
  static HostHook<throng_misuse_hook> hook;
  return hook;
}

HostHook<throng_thread_hook>& thread_hook() {
  static HostHook<throng_thread_hook> hook;
  return hook;
}

void tell_of_misuse(const Misuse& misuse) { misuse_hook().call(misuse.call, misuse.reason); }
void tell_of_thread(int pu) { thread_hook().call(pu); }

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

void throng_set_misuse_hook(throng_misuse_hook hook, void* user) {
  misuse_hook().set(hook, user);
  set_misuse_hook(hook == nullptr ? nullptr : tell_of_misuse);
}

int throng_set_memory_hooks(throng_allocate allocate, throng_release release, void* user) {
  const Call call("throng_set_memory_hooks");
  set_memory_hooks({.allocate = allocate, .release = release, .context = user});
  return call.outcome();
}

int throng_set_zone_hooks(throng_begin_zone begin, throng_end_zone end, void* user) {
  const Call call("throng_set_zone_hooks");
  set_zone_hooks({.begin = begin, .end = end, .context = user});
  return call.outcome();
}

void throng_set_thread_hook(throng_thread_hook hook, void* user) {
  thread_hook().set(hook, user);
  set_thread_hook(hook == nullptr ? nullptr : tell_of_thread);
}
