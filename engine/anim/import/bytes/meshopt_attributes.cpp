#include "engine/anim/import/bytes/meshopt_attributes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "engine/anim/import/bytes/refusal.h"

namespace throng::import {

namespace {

constexpr std::byte header_v1{0xA1};
constexpr std::size_t group_size = 16;
constexpr std::size_t largest_block = 256;  // elements
constexpr std::size_t block_bytes = 8192;
constexpr std::size_t channel_bytes = 4;
constexpr std::size_t least_tail = 24;  // bytes

using Bytes = std::span<const std::byte>;
using Column = std::array<std::uint8_t, largest_block>;  // a byte of each element

unsigned value_of(std::byte byte) { return std::to_integer<unsigned>(byte); }

class BlockReader {
 public:
  explicit BlockReader(Bytes bytes) : rest_(bytes) {}

  Bytes take(std::size_t count) {
    if (count > rest_.size()) throw Refusal("its bytes end too early");
    const Bytes taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }

  bool is_at_end() const { return rest_.empty(); }

  /// Reads a byte of each of `count` elements, in the way that the control mode says.
  void read_column(unsigned control, std::size_t count, Column& column) {
    if (control == 2) {
      column.fill(0);
    } else if (control == 3) {
      std::ranges::transform(take(count), column.begin(),
                             [](std::byte byte) { return static_cast<std::uint8_t>(byte); });
    } else {
      read_groups(control, count, column);
    }
  }

 private:
  /// Two bits a group say how many bits a delta has.
  void read_groups(unsigned control, std::size_t count, Column& column) {
    constexpr std::array<std::array<unsigned, 4>, 2> bits_by_mode{{{0, 1, 2, 4}, {1, 2, 4, 8}}};
    const std::size_t groups = (count + group_size - 1) / group_size;
    const Bytes modes = take((groups + 3) / 4);
    for (std::size_t group = 0; group < groups; ++group) {
      const unsigned mode = (value_of(modes[group / 4]) >> (group % 4 * 2)) & 3U;
      read_group(bits_by_mode[control][mode], column.data() + group * group_size);
    }
  }

  /// A delta of all ones stands for a byte that follows the group.
  void read_group(unsigned bits, std::uint8_t* to) {
    const Bytes packed = take(bits * group_size / 8);
    const unsigned sentinel = (1U << bits) - 1;
    for (std::size_t i = 0; i < group_size; ++i) {
      const unsigned delta = bits == 0 ? 0 : packed_delta(packed, bits, i);
      const bool is_whole = bits > 0 && bits < 8 && delta == sentinel;
      to[i] = static_cast<std::uint8_t>(is_whole ? value_of(take(1).front()) : delta);
    }
  }

  /// Single bits begin with the lowest of a byte, wider deltas with the highest.
  static unsigned packed_delta(Bytes packed, unsigned bits, std::size_t i) {
    const std::size_t a_byte = 8 / bits, place = i % a_byte;
    const std::size_t shift = bits == 1 ? place : (a_byte - 1 - place) * bits;
    return (value_of(packed[i / a_byte]) >> shift) & ((1U << bits) - 1);
  }

  Bytes rest_;
};

template <typename Word>
Word without_zigzag(Word value) {
  const auto half = static_cast<Word>(value >> 1U);
  return (value & 1U) != 0 ? static_cast<Word>(~half) : half;
}

/// Adds up the deltas of the bytes from `byte` on that make a Word, in every element of a block.
template <typename Word, typename Next>
void add_up(std::span<const Column, channel_bytes> columns, std::size_t byte, std::span<std::byte> block,
            std::size_t stride, std::byte* before, const Next& next) {
  Word value{};
  std::memcpy(&value, before + byte, sizeof(Word));
  for (std::size_t element = 0; element * stride < block.size(); ++element) {
    std::uint32_t delta = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i) delta |= std::uint32_t{columns[byte + i][element]} << (8 * i);
    value = next(static_cast<Word>(delta), value);
    std::memcpy(block.data() + element * stride + byte, &value, sizeof(Word));
  }
  std::memcpy(before + byte, &value, sizeof(Word));
}

/// Makes four bytes of each element of a block. `block` begins with the channel; `before` has it of the element before.
void decode_channel(std::span<const Column, channel_bytes> columns, unsigned mode, std::span<std::byte> block,
                    std::size_t stride, std::byte* before) {
  const unsigned rotation = mode >> 4U;
  const auto add = [](auto delta, auto value) { return static_cast<decltype(value)>(without_zigzag(delta) + value); };
  if (mode == 0) {
    for (std::size_t byte = 0; byte < 4; ++byte) add_up<std::uint8_t>(columns, byte, block, stride, before, add);
  } else if (mode == 1) {
    for (std::size_t byte = 0; byte < 4; byte += 2) add_up<std::uint16_t>(columns, byte, block, stride, before, add);
  } else if ((mode & 15U) == 2) {
    add_up<std::uint32_t>(columns, 0, block, stride, before, [rotation](std::uint32_t delta, std::uint32_t value) {
      return std::rotr(delta, static_cast<int>(rotation)) ^ value;
    });
  } else {
    throw Refusal("channel mode " + std::to_string(mode) + " is unknown");
  }
}

template <typename Part, typename SignedPart>
void decode_color(std::byte* element) {
  constexpr auto most = static_cast<float>(std::numeric_limits<Part>::max());
  std::array<Part, 4> parts{};
  std::memcpy(parts.data(), element, sizeof parts);
  const unsigned scale = (1U << static_cast<unsigned>(std::bit_width(parts[3]))) - 1U;
  if (scale == 0) throw Refusal("a colour has no scale");
  const int y = parts[0], orange = static_cast<SignedPart>(parts[1]), green = static_cast<SignedPart>(parts[2]);
  const unsigned low = parts[3] & (scale >> 1U);
  const auto alpha = static_cast<int>((low << 1U) | (low & 1U));
  const std::array<int, 4> rgba{y + orange - green, y + green, y - orange - green, alpha};
  for (std::size_t i = 0; i < 4; ++i) {
    const float value = std::round(static_cast<float>(rgba[i]) * (most / static_cast<float>(scale)));
    parts[i] = static_cast<Part>(std::clamp(value, 0.0F, most));
  }
  std::memcpy(element, parts.data(), sizeof parts);
}

}  // namespace

bool is_attribute_stream_v1(Bytes bytes) { return !bytes.empty() && bytes.front() == header_v1; }

void decode_attributes_v1(Bytes bytes, std::size_t stride, std::span<std::byte> elements) {
  const std::size_t channels = stride / channel_bytes;
  const std::size_t tail = std::max(stride + channels, least_tail);
  if (bytes.size() < 1 + tail) throw Refusal("its bytes end too early");
  const Bytes modes = bytes.last(channels);
  std::array<std::byte, largest_block> before{};
  std::ranges::copy(bytes.last(stride + channels).first(stride), before.begin());
  BlockReader reader(bytes.subspan(1, bytes.size() - 1 - tail));
  const std::size_t most = std::min(block_bytes / stride / group_size * group_size, largest_block);
  std::array<Column, channel_bytes> columns{};
  while (!elements.empty()) {
    const std::size_t count = std::min(most, elements.size() / stride);
    const std::span<std::byte> block = elements.first(count * stride);
    elements = elements.subspan(count * stride);
    const Bytes controls = reader.take(channels);
    for (std::size_t channel = 0; channel < channels; ++channel) {
      for (std::size_t byte = 0; byte < channel_bytes; ++byte) {
        reader.read_column((value_of(controls[channel]) >> (2 * byte)) & 3U, count, columns[byte]);
      }
      const std::size_t first = channel * channel_bytes;
      decode_channel(columns, value_of(modes[channel]), block.subspan(first), stride, before.data() + first);
    }
  }
  if (!reader.is_at_end()) throw Refusal("bytes are left after its elements");
}

void decode_color_filter(std::span<std::byte> elements, std::size_t stride) {
  for (std::size_t at = 0; at < elements.size(); at += stride) {
    if (stride == 4) {
      decode_color<std::uint8_t, std::int8_t>(elements.data() + at);
    } else {
      decode_color<std::uint16_t, std::int16_t>(elements.data() + at);
    }
  }
}

}  // namespace throng::import
