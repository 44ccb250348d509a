#pragma once

#include <cstddef>
#include <span>

namespace throng::import {

/// Returns whether no Huffman table of a JPEG says that it has more than 256 codes (ITU T.81, B.2.4.2). stb_image 2.27,
/// which Debian 12 has, writes all that it says into an array of 256. True for bytes that are no JPEG.
bool jpeg_tables_fit(std::span<const std::byte> bytes);

}  // namespace throng::import
