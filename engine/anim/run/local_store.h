#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/base/guard.h"
#include "engine/anim/run/trace.h"

namespace throng::anim {

/// A PU's own memory of fixed size (paper 1.1, 3):
///
///     0                 fetch bytes         2 x fetch bytes               size
///     +-----------------+-------------------+------------------------------+
///     | fetch buffer 0  | fetch buffer 1    | scratch                      |
///     +-----------------+-------------------+------------------------------+
///
/// Blocks are copied to a fetch buffer, updated there and copied back; kernels touch nothing but this and read-only
/// assets. Without double buffering the second fetch buffer has no bytes.
class LocalStore {
 public:
  explicit LocalStore(std::size_t size);

  /// Splits the store anew; the sizes are multiples of 64 and fit.
  void divide(std::size_t fetch_bytes, int fetch_buffers, std::size_t scratch_bytes);

  std::span<std::byte> fetch_buffer(int index) const;
  std::span<std::byte> scratch() const;
  std::size_t size() const { return size_; }
  /// Laid out by divide(); the most that a task can use.
  std::size_t bytes_used() const { return fetch_bytes_ * static_cast<std::size_t>(fetch_buffers_) + scratch_bytes_; }

 private:
  std::size_t size_;
  AlignedBytes memory_;
  std::size_t fetch_bytes_ = 0;
  int fetch_buffers_ = 2;
  std::size_t scratch_bytes_ = 0;
};

/// The DMA controller's part (paper footnote 7), played by the PU's own thread: a list of transfers between main memory
/// and the local store, moved at once by finish() or, some at a time, by advance(), which kernels call between packets
/// of bones. The only code that touches guarded pool memory (see base/guard.h).
class CopyEngine {
 public:
  /// Room for `transfers` queued at once, so that queueing never allocates in the frame.
  void reserve(std::size_t transfers) { queue_.reserve(transfers); }

  /// Queue. Addresses and sizes are multiples of 64 bytes. A fetch closes its destination until its bytes have arrived.
  void fetch(const std::byte* main_memory, std::byte* local, std::size_t size) {
    assert(size % block_alignment == 0);
    guard(local, size);
    queued_.bytes_in += size;
    queue_.push_back({main_memory, local, size, true});
  }
  void write_back(const std::byte* local, std::byte* main_memory, std::size_t size) {
    assert(size % block_alignment == 0);
    queued_.bytes_out += size;
    queue_.push_back({local, main_memory, size, false});
  }

  /// Cuts what is queued into `slices` about equal parts of whole transfers, one for each advance(). Of some tasks the
  /// trace is told of each.
  void spread_over(int slices, Trace* trace = nullptr);
  void advance();
  /// Moves all that is left; returns what was queued since the last finish().
  CopyCounts finish();

  /// Since it was last asked.
  CopyCounts take_counts();

  struct Transfer {
    const std::byte* from;
    std::byte* to;
    std::size_t size;
    bool inward;  ///< to the local store
  };
  /// Since the last finish().
  std::span<const Transfer> queued() const { return queue_; }

 private:
  void begin_first() const;
  void move(std::size_t due);

  std::vector<Transfer> queue_;
  std::size_t moved_ = 0;  // transfers that are done
  std::size_t moved_bytes_ = 0;
  std::size_t due_bytes_ = 0;  // that are to be moved by the end of this slice
  std::size_t slice_bytes_ = 0;
  CopyCounts queued_;  // since the last finish(); transfers are counted then
  CopyCounts counts_;  // of what is finished
  Trace* slices_to_ = nullptr;
};

}  // namespace throng::anim
