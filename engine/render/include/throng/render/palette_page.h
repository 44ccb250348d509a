#pragma once

#include <cstddef>

namespace throng::render {

inline constexpr std::size_t palette_line_bytes = 64;  ///< a cache line; slots are whole lines

/// A page of palette memory: persistently mapped memory of the device, or plain memory where there is no OpenGL.
struct PalettePage {
  std::byte* memory = nullptr;  ///< aligned to 64 bytes; may be write-combined: write whole lines in order, never read
  std::size_t size = 0;         ///< bytes
};

/// Makes pages. It is asked on the GL thread only, never while animation runs.
class PalettePageSource {
 public:
  virtual ~PalettePageSource() = default;
  /// Gives a new page, whose memory is null when the device has no more.
  virtual PalettePage add_page() = 0;
};

}  // namespace throng::render
