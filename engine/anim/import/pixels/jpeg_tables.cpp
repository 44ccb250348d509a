#include "engine/anim/import/pixels/jpeg_tables.h"

namespace throng::import {
namespace {

constexpr unsigned fill = 0xFF, first_restart = 0xD0, end_of_image = 0xD9, huffman_tables = 0xC4;

/// The bytes of a JPEG; beyond the end, zeros, as the decoder reads them.
class TableReader {
 public:
  explicit TableReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  unsigned at(std::size_t place) const { return place < bytes_.size() ? std::to_integer<unsigned>(bytes_[place]) : 0; }
  std::size_t size() const { return bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
};

/// Checks the tables that begin within a segment; the decoder reads the last one to its end, even outside of it.
bool tables_fit(const TableReader& bytes, std::size_t at, std::size_t end) {
  while (at < end && at < bytes.size()) {
    unsigned codes = 0;
    for (std::size_t length = 1; length <= 16; ++length) codes += bytes.at(at + length);
    if (codes > 256) return false;
    at += 17 + codes;
  }
  return true;
}

bool has_length(unsigned marker) {
  return marker != 0 && marker != 1 && (marker < first_restart || marker > end_of_image);
}

}  // namespace

bool jpeg_tables_fit(std::span<const std::byte> all) {
  const TableReader bytes(all);
  if (bytes.at(0) != fill) return true;
  for (std::size_t at = 0; at + 1 < bytes.size();) {
    const unsigned marker = bytes.at(at + 1);
    if (bytes.at(at) != fill || marker == fill) {
      ++at;  // pixels, or bytes that fill
      continue;
    }
    at += 2;
    if (!has_length(marker)) continue;
    const std::size_t end = at + bytes.at(at) * std::size_t{256} + bytes.at(at + 1);
    if (marker == huffman_tables && !tables_fit(bytes, at + 2, end)) return false;
    if (end > at) at = end;
  }
  return true;
}

}  // namespace throng::import
