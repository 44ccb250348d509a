#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <span>

#include "engine/base/result.h"

namespace throng {

/// Reads a descriptor that may have nothing for long, and that stays the caller's. Another thread can end the wait.
/// Errors are the ends of sentences that begin with the name of the input: "it cannot be read: ...".
class WaitingInput {
 public:
  explicit WaitingInput(int descriptor) : descriptor_(descriptor) {}
  ~WaitingInput();
  WaitingInput(const WaitingInput&) = delete;
  WaitingInput& operator=(const WaitingInput&) = delete;

  /// Makes it ready to be read and to be stopped.
  Status open();
  /// Waits for bytes and reads some. Returns how many were read: 0 at the end, and nothing once it is stopped.
  Result<std::optional<std::size_t>> read(std::span<char> bytes);
  /// Ends read() in another thread, and each later one.
  void stop();

 private:
  int descriptor_;
  std::array<int, 2> ends_{-1, -1};  // of a pipe, where the system can wait for two: its end is closed to stop
  std::atomic<bool> is_stopped_ = false;
};

}  // namespace throng
