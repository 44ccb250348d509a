#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "throng/render/palette_page.h"

namespace throng {

/// A run of lines in a page, to which one pose of one agent is written.
struct PaletteSlot {
  static constexpr std::uint32_t none = UINT32_MAX;
  std::uint32_t page = none;
  std::uint32_t first_line = 0;  ///< counted from the page's start
  std::uint32_t lines = 0;       ///< the number of lines that it holds
  bool valid() const { return page != none; }
};

/// Hands out the slots that poses are written to (see the contract in engine/render/README.md):
///  - acquire() gives a slot that no frame in flight reads. A PU writes it once; draws read it until it is retired.
///  - retire(slot, last_frame) says that no frame after `last_frame` reads the slot.
///  - reclaim(completed) frees every slot that was retired with frame `completed` or an earlier one. `completed` is the
///    newest frame whose fence has signalled.
/// One draw must be able to read both slots of an agent, so both lie on one page: pass the page of the first as `near`.
/// An agent's first slot (without `near`) comes from a page that is less than a third full, because the agent needs a
/// second slot there, and a third while a retired one waits for its frame. If `near` is full nevertheless, the agent
/// moves: acquire a slot without `near` and show it alone.
/// Use it on the GL thread only. It allocates nothing once the pages exist and the free lists have grown.
class PaletteSlots {
 public:
  /// `sizes` lists, in any order, the sizes of slots that will be asked for: of each bone level of each character.
  PaletteSlots(render::PalettePageSource& source, const std::vector<std::size_t>& sizes);

  /// Gives a slot of at least `bytes`, which may be at most the largest of the sizes. The slot is invalid when no
  /// memory is left, or none on page `near` where that is given; the agent is then not drawn.
  PaletteSlot acquire(std::size_t bytes, std::uint32_t near = PaletteSlot::none);
  void retire(const PaletteSlot& slot, std::uint64_t last_frame);
  void reclaim(std::uint64_t completed_frame);

  /// Gives the memory that a PU writes to. Debug builds assert that the slot is acquired and not retired.
  std::byte* memory(const PaletteSlot& slot) const;

  /// Says whether this very slot is acquired and not retired: its owner alone writes and frees it.
  bool is_acquired(const PaletteSlot& slot) const;

  std::size_t page_count() const { return pages_.size(); }
  std::size_t slots_in_use() const { return in_use_; }
  std::size_t bytes_in_use() const { return bytes_in_use_; }

 private:
  struct Page {
    render::PalettePage memory;
    std::uint32_t next_line = 0;                           ///< no slot was ever handed out from here on
    std::uint32_t lines_in_use = 0;                        ///< including lines of retired slots
    std::vector<std::vector<std::uint32_t>> free_by_size;  ///< first lines of free slots, one list a size
    /// A bit by first line: the slot there is acquired. It has the same lines each time, since slots are never cut.
    std::vector<std::uint64_t> acquired;
  };
  struct Retired {
    PaletteSlot slot;
    std::uint64_t last_frame;
  };

  std::size_t size_index(std::uint32_t lines) const;
  bool has_room_for_newcomer(const Page& page) const;
  bool add_page();
  PaletteSlot take(std::uint32_t page, std::uint32_t lines);

  render::PalettePageSource* source_;
  std::vector<std::uint32_t> sizes_;  ///< lines of a slot, each size once, descending
  std::vector<Page> pages_;
  std::vector<Retired> retired_;
  std::size_t in_use_ = 0;
  std::size_t bytes_in_use_ = 0;
};

}  // namespace throng
