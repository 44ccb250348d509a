#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "engine/anim/agent/exact_poser.h"
#include "engine/anim/agent/fitted_scheduler.h"
#include "engine/anim/agent/frame_work.h"
#include "engine/anim/agent/population.h"
#include "engine/anim/base/misuse.h"

namespace throng::anim {

/// The right to change a system, which one call has at a time. It is a guard against misuse and no lock: a call during
/// another call is refused, on any thread.
class Turn {
 public:
  Turn(std::atomic<bool>& taken, const char* call)
      : taken_(&taken), call_(call), has_it_(!taken.exchange(true, std::memory_order_acquire)) {
    if (!has_it_) report("the system is in the middle of another call, on this thread or another one");
  }
  ~Turn() {
    if (has_it_) taken_->store(false, std::memory_order_release);
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  explicit operator bool() const { return has_it_; }
  /// Returns the error of a call that has no turn.
  static Error refusal() { return Error{"the system is in the middle of another call"}; }
  /// Reports a misuse of the call, and returns false.
  bool report(const char* reason) const { return report_misuse({call_, reason}); }
  /// Reports a misuse of the call, and returns it as the error of the call.
  Error refuse(const char* reason) const { return anim::refuse({call_, reason}); }

 private:
  std::atomic<bool>* taken_;
  const char* call_;
  bool has_it_;
};

/// The memory of a call that takes requests to many agents (many_requests.h).
struct ManyScratch {
  std::vector<std::uint32_t> calls;  // [agent] the last call that named the agent
  std::uint32_t call = 0;            // the number of the present call
  std::vector<std::uint8_t> waits;   // [request] the caller's thread takes it, after the PUs
};

/// The inside of an AnimationSystem. The system, its characters, its agents and its figures work on it.
struct SystemParts {
  Population population;
  FittedScheduler pus;
  FrameWork frame;
  ExactPoser exact;
  ManyScratch many;
  mutable std::atomic<bool> turn{false};  ///< some call changes the system; see Turn
};

}  // namespace throng::anim
