#pragma once

#include "throng/render/palette_page.h"
#include "throng/standard.h"

namespace throng {

/// Makes palette pages of plain memory, for hosts that copy palettes to the device themselves, and for runs without
/// one.
class HeapPageSource final : public render::PalettePageSource {
 public:
  explicit HeapPageSource(std::size_t page_bytes) : page_bytes_(page_bytes) {}
  render::PalettePage add_page() override;
  /// Frees every page. The view that had them must be gone.
  void drop_pages() { pages_.clear(); }
  std::size_t page_count() const { return pages_.size(); }
  /// Returns the memory of a page, CrowdBatch::page.
  const std::byte* memory(std::size_t page) const { return pages_[page][0].bytes; }

 private:
  struct alignas(render::palette_line_bytes) Line {
    std::byte bytes[render::palette_line_bytes];
  };
  std::size_t page_bytes_;
  std::vector<std::unique_ptr<Line[]>> pages_;
};

}  // namespace throng
