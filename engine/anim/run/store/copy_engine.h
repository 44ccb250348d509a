#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/base/guard.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/anim/run/store/trace.h"

namespace throng::anim {

/// Blocks of one size, one of each of some characters. They are anywhere in main memory, and evenly spaced in the local
/// store. Addresses and sizes are multiples of 64 bytes.
struct BlockRow {
  std::span<std::byte* const> blocks{};  ///< addresses in main memory; the list stays as it is until it is moved
  std::byte* local = nullptr;            ///< the first block in the local store
  std::size_t stride = 0;                ///< from one to the next in the local store
  std::size_t size = 0;
};

/// The DMA controller's part (paper footnote 7), played by the PU's own thread: a list of transfers between main memory
/// and the local store, moved at once by finish() or, some at a time, by advance(), which kernels call between packets
/// of bones. It is the only code that touches guarded pool memory (see base/guard.h).
class CopyEngine {
 public:
  /// Makes room for `transfers` queued at once, so that queueing never allocates in the frame.
  void reserve(std::size_t transfers) { queue_.reserve(transfers); }
  /// Sets the kernels that move rows; the best that this machine runs unless this is called.
  void use(const Kernels& kernels) { kernels_ = &kernels; }

  /// Queues a row, each block a transfer of all but its first `skipped` bytes, which stay as they are. A fetch closes
  /// its destinations until their bytes have arrived. Bytes that never arrive stay closed.
  void fetch(const BlockRow& row, std::size_t skipped) { push({.row = row, .skipped = skipped, .inward = true}); }
  void write_back(const BlockRow& row, std::size_t skipped) { push({.row = row, .skipped = skipped}); }
  /// Moves a row at once, while it lies in a near cache. It is counted with the queued rows.
  void write_back_now(const BlockRow& row, std::size_t skipped);
  /// Queues one block.
  void fetch(const std::byte* main_memory, std::byte* local, std::size_t size) {
    push({.row = {.local = local, .size = size}, .only = const_cast<std::byte*>(main_memory), .inward = true});
  }
  void write_back(const std::byte* local, std::byte* main_memory, std::size_t size) {
    push({.row = {.local = const_cast<std::byte*>(local), .size = size}, .only = main_memory});
  }

  /// Cuts the queue into `slices` about equal parts of whole rows, one for each advance(). A part is asked for one
  /// advance() before its own, so that it comes near while kernels compute. Blocks that go out are moved part by part,
  /// and blocks that come in with the last part. `trace` gets each part of some tasks.
  void spread_over(int slices, Trace* trace = nullptr);
  void advance();
  /// Moves the rest of the queue, and returns the counts of all rows since the last finish().
  CopyCounts finish();

  /// Returns the counts of moved rows since the last call.
  CopyCounts take_counts();

  struct Transfer {
    const std::byte* from;
    std::byte* to;
    std::size_t size;
    bool inward;  ///< to the local store
  };
  /// Returns the transfers queued since the last finish(). For tests: it allocates.
  std::vector<Transfer> queued() const;

 private:
  struct Entry {
    BlockRow row;
    std::byte* only = nullptr;  // block of a row of one; null: row.blocks has them
    std::size_t skipped = 0;
    bool inward = false;

    std::span<std::byte* const> blocks() const { return only == nullptr ? row.blocks : std::span(&only, 1); }
    std::byte* local(std::size_t i) const { return row.local + i * row.stride; }
    std::size_t moved_size() const { return row.size - skipped; }
    std::size_t moved_bytes() const { return blocks().size() * moved_size(); }
  };

  void push(const Entry& entry) {
    assert(entry.row.size % block_alignment == 0 && entry.row.stride % block_alignment == 0);
    const std::size_t count = entry.blocks().size();
    for (std::size_t i = 0; entry.inward && i < count; ++i) guard(entry.local(i), entry.row.size);
    (entry.inward ? queued_.bytes_in : queued_.bytes_out) += count * entry.moved_size();
    queued_.transfers += count;
    queue_.push_back(entry);
  }
  bool is_next_due() const;
  void move_rows();
  void ask_for_rows(std::size_t due);
  void move_row(const Entry& entry) const;

  const Kernels* kernels_ = &best_kernels();
  std::vector<Entry> queue_;
  std::size_t moved_rows_ = 0;
  std::size_t moved_bytes_ = 0;
  std::size_t asked_rows_ = 0;  // rows that are on their way to a near cache, or were not worth it
  std::size_t asked_bytes_ = 0;
  std::size_t due_bytes_ = 0;  // bytes that must be moved, or near, by the end of this slice
  std::size_t slice_bytes_ = 0;
  int slices_left_ = 0;
  CopyCounts queued_;  // queued since the last finish()
  CopyCounts counts_;  // finished since the last take_counts()
  Trace* slices_to_ = nullptr;
};

}  // namespace throng::anim
