#pragma once

#include <atomic>

#include "engine/anim/base/misuse.h"

namespace throng::anim {

/// The right to change a system, which one call has at a time. It is a guard against misuse and no lock: a call that
/// comes while another is at work is refused, on whatever thread.
class Turn {
 public:
  Turn(std::atomic<bool>& taken, const char* call) : taken_(&taken), has_it_(!taken.exchange(true)) {
    if (!has_it_) report_misuse({call, "the system is in the middle of another call, on this thread or another one"});
  }
  ~Turn() {
    if (has_it_) taken_->store(false);
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  explicit operator bool() const { return has_it_; }
  /// Returns the error of a call that has no turn.
  static Error refusal() { return Error{"the system is in the middle of another call"}; }

 private:
  std::atomic<bool>* taken_;
  bool has_it_;
};

}  // namespace throng::anim
