#pragma once

#include <cstddef>
#include <span>

#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// The sizes into which a local store is divided for one schedule.
struct LocalStorePlan {
  int width = 1;                ///< characters a strip, which kernels pose side by side
  int strips = 1;               ///< strips a tile, where that many fit
  std::size_t fetch_bytes = 0;  ///< size of each fetch buffer
  int fetch_buffers = 2;        ///< 1 without double buffering
  std::size_t scratch_bytes = 0;
  std::size_t shared_bytes = 0;  ///< part of a fetch buffer for blocks that others own

  /// Returns the room for the rare entity of `levels` that one buffer cannot hold.
  std::size_t all_fetch_bytes() const { return fetch_bytes * static_cast<std::size_t>(fetch_buffers); }
};

/// A PU's own memory of fixed size (paper 1.1, 3):
///
///     0                 fetch bytes         2 x fetch bytes               size
///     +-----------------+-------------------+------------------------------+
///     | fetch buffer 0  | fetch buffer 1    | scratch                      |
///     +-----------------+-------------------+------------------------------+
///
/// Blocks are copied to a fetch buffer, updated there and copied back. Kernels touch nothing but this memory and
/// read-only assets. The second fetch buffer has no bytes without double buffering.
class LocalStore {
 public:
  explicit LocalStore(std::size_t size);

  /// Splits the store anew. The sizes are multiples of 64 and must fit.
  void divide(std::size_t fetch_bytes, int fetch_buffers, std::size_t scratch_bytes);

  std::span<std::byte> fetch_buffer(int index) const;
  std::span<std::byte> scratch() const;
  std::size_t size() const { return size_; }
  /// Returns the bytes that divide() laid out, which are the most that a task can use.
  std::size_t bytes_used() const { return fetch_bytes_ * static_cast<std::size_t>(fetch_buffers_) + scratch_bytes_; }

 private:
  std::size_t size_;
  AlignedBytes memory_;
  std::size_t fetch_bytes_ = 0;
  int fetch_buffers_ = 2;
  std::size_t scratch_bytes_ = 0;
};

}  // namespace throng::anim
