#pragma once

#include <cstddef>
#include <vector>

#include "throng/render/palette_page.h"

#include "engine/render/gl/handles.h"

namespace throng::render {

/// Makes palette pages in buffers that are mapped persistently and coherently. Shaders read them as storage blocks.
/// The first page has 16 MiB, and each further one twice as much as the last, but none more than a storage block of the
/// device. The context must be current when a PaletteBuffer is made, used and destroyed.
class PaletteBuffer final : public PalettePageSource {
 public:
  static constexpr std::size_t first_page_bytes = std::size_t{16} << 20U;
  static constexpr std::size_t largest_page_bytes = std::size_t{128} << 20U;

  explicit PaletteBuffer(std::size_t first_page = first_page_bytes);

  PalettePage add_page() override;
  /// Takes all pages back, once the device has finished reading them. The first one is lent again, since new memory
  /// costs a frame on a device that is a processor.
  void take_back_pages();

  std::size_t page_count() const { return lent_; }

  /// Binds a page as storage block `binding` of every program.
  void bind(std::uint32_t page, GLuint binding) const;

 private:
  struct Page {
    gl::Buffer buffer;
    PalettePage memory;
  };
  std::size_t first_page_bytes_;
  std::size_t block_limit_ = 0;
  std::vector<Page> pages_;
  std::size_t lent_ = 0;  // of pages_; the page behind them waits
};

}  // namespace throng::render
