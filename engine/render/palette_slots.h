#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace throng::render {

inline constexpr std::size_t palette_line_bytes = 64;  ///< a cache line: what slots are counted in

/// A page of palette memory: persistently mapped GPU memory, or plain memory where there is no GL.
struct PalettePage {
  std::byte* memory = nullptr;  ///< 64-byte aligned; may be write-combined: write whole lines in order, never read
  std::size_t size = 0;         ///< bytes
};

/// Where pages come from. Asked on the GL thread only, never while animation runs.
class PalettePageSource {
 public:
  virtual ~PalettePageSource() = default;
  /// A new page, or one with null memory when the device has no more.
  virtual PalettePage add_page() = 0;
};

/// Plain memory, for runs without GL.
class HeapPageSource final : public PalettePageSource {
 public:
  explicit HeapPageSource(std::size_t page_bytes);
  ~HeapPageSource() override;
  PalettePage add_page() override;

 private:
  struct Page;
  std::size_t page_bytes_;
  std::vector<std::unique_ptr<Page>> pages_;
};

/// A run of lines in a page that one pose of one agent is written to.
struct PaletteSlot {
  static constexpr std::uint32_t none = UINT32_MAX;
  std::uint32_t page = none;
  std::uint32_t first_line = 0;  ///< from the page's start
  std::uint32_t lines = 0;       ///< capacity
  bool valid() const { return page != none; }
};

/// The slot writer's half of the contract between animation and drawing (engine/render/README.md):
///  - acquire() gives a slot that no frame in flight reads; the PU writes it once; draws read it until it is retired;
///  - retire(slot, last_frame) says that frame `last_frame` was the last whose draws read it;
///  - reclaim(completed) makes free every slot retired with a frame at or before `completed`, the newest whose fence
///  has signalled.
/// Both slots of an agent lie on one page, so that one draw can read both: pass the page of the first as `near`. An
/// agent's first slot (no `near`) is taken only from a page less than a third full, because the agent will need a
/// second slot there, and one more while a retired one waits for its frame. Where `near` is full all the same, the
/// agent moves: acquire without `near` and show the new slot alone. Single-threaded (GL thread). No allocation once the
/// pages are there and the free lists have grown.
class PaletteSlots {
 public:
  /// `sizes`: how many bytes slots will be asked for, those of each character's bone levels, in any order.
  PaletteSlots(PalettePageSource& source, const std::vector<std::size_t>& sizes);

  /// Room for so many bytes, at most the largest of the sizes; the next of them is taken. An invalid slot means: no
  /// memory left (on `near`, where given); the agent is not drawn. A slot may be larger than it needs to be.
  PaletteSlot acquire(std::size_t bytes, std::uint32_t near = PaletteSlot::none);
  void retire(const PaletteSlot& slot, std::uint64_t last_frame);
  void reclaim(std::uint64_t completed_frame);

  /// Where the PU writes. Debug builds assert that the slot is acquired and not retired.
  std::byte* memory(const PaletteSlot& slot) const;

  /// Whether this very slot is acquired and not retired, so that nobody else writes or frees it.
  bool is_acquired(const PaletteSlot& slot) const;

  std::size_t page_count() const { return pages_.size(); }
  std::size_t slots_in_use() const { return in_use_; }
  std::size_t bytes_in_use() const { return bytes_in_use_; }

 private:
  struct Page {
    PalettePage memory;
    std::uint32_t next_line = 0;                           ///< never handed out beyond here
    std::uint32_t lines_in_use = 0;                        ///< retired ones included
    std::vector<std::vector<std::uint32_t>> free_by_size;  ///< first lines, a list a size
    std::vector<std::uint32_t> acquired;                   ///< by first line: lines of the slot there, or 0
  };
  struct Retired {
    PaletteSlot slot;
    std::uint64_t last_frame;
  };

  std::size_t size_index(std::uint32_t lines) const;
  bool has_room_for_newcomer(const Page& page) const;
  bool add_page();
  PaletteSlot take(std::uint32_t page, std::uint32_t lines);

  PalettePageSource* source_;
  std::vector<std::uint32_t> sizes_;  ///< in lines, each once, descending
  std::vector<Page> pages_;
  std::vector<Retired> retired_;
  std::size_t in_use_ = 0;
  std::size_t bytes_in_use_ = 0;
};

}  // namespace throng::render
