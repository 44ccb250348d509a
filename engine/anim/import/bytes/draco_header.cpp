#include "engine/anim/import/bytes/draco_header.h"

#include <string>
#include <string_view>

#include "engine/anim/import/bytes/refusal.h"

namespace throng::import {

namespace {

constexpr std::string_view draco_magic = "DRACO";
constexpr std::uint8_t triangular_mesh = 1;
constexpr std::uint8_t edgebreaker = 1;
constexpr std::uint8_t valence_walk = 2;
constexpr unsigned has_metadata = 0x8000;
constexpr int max_metadata_depth = 16;

class HeadReader {
 public:
  explicit HeadReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  void skip(std::uint64_t count) {
    if (count > rest_.size()) throw Refusal("its Draco mesh is cut short");
    rest_ = rest_.subspan(static_cast<std::size_t>(count));
  }

  std::uint8_t byte() {
    skip(1);
    return static_cast<std::uint8_t>(*(rest_.data() - 1));
  }

  /// Reads seven bits a byte, lowest first.
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      const std::uint64_t bits = byte();
      value |= (bits & 0x7FU) << shift;
      if (bits < 0x80U) return value;
    }
    throw Refusal("its Draco mesh has a number that does not end");
  }

  /// Skips entries by name, and the entries nested below them.
  void skip_metadata(int depth) {
    if (depth > max_metadata_depth) throw Refusal("the metadata of its Draco mesh are nested too deep");
    for (std::uint64_t left = number(); left > 0; --left) {
      skip(byte());
      skip(number());
    }
    for (std::uint64_t left = number(); left > 0; --left) {
      skip(byte());
      skip_metadata(depth + 1);
    }
  }

 private:
  std::span<const std::byte> rest_;
};

}  // namespace

DracoCounts read_draco_counts(std::span<const std::byte> bytes) {
  HeadReader head(bytes);
  for (const char letter : draco_magic) {
    if (head.byte() != static_cast<std::uint8_t>(letter)) throw Refusal("its bytes are no Draco mesh");
  }
  const unsigned major = head.byte(), minor = head.byte();
  if (major != 2 || minor != 2) {
    throw Refusal("its Draco mesh has version " + std::to_string(major) + "." + std::to_string(minor) + ", not 2.2");
  }
  if (head.byte() != triangular_mesh) throw Refusal("its Draco data are no mesh");
  const bool by_edges = head.byte() == edgebreaker;
  const unsigned low = head.byte(), flags = low | (unsigned{head.byte()} << 8U);
  if ((flags & has_metadata) != 0) {
    for (std::uint64_t left = head.number(); left > 0; --left) {
      head.number();
      head.skip_metadata(0);
    }
    head.skip_metadata(0);
  }
  if (!by_edges) {
    const std::uint64_t faces = head.number();
    return {.faces = faces, .points = head.number(), .seams = 0, .by_valence = false};
  }
  const bool by_valence = head.byte() == valence_walk;
  const std::uint64_t points = head.number(), triangles = head.number();
  return {.faces = triangles, .points = points, .seams = head.byte(), .by_valence = by_valence};
}

}  // namespace throng::import
