#include "tests/fuzz/mutator.h"

#include <algorithm>
#include <array>

namespace throng::fuzz {
namespace {

constexpr std::size_t longest_piece = 64, longest_input = 65'536;

std::ptrdiff_t offset(std::size_t at) { return static_cast<std::ptrdiff_t>(at); }

}  // namespace

// xorshift64*, since the standard's distributions differ from library to library.
std::uint64_t Mutator::next() {
  state_ ^= state_ >> 12U;
  state_ ^= state_ << 25U;
  state_ ^= state_ >> 27U;
  return (state_ * 0x2545F4914F6CDD1DULL) >> 16U;
}

Bytes Mutator::damaged(Bytes input, std::span<const std::uint8_t> other) {
  for (std::size_t left = 1 + below(4); left > 0 && !input.empty(); --left) damage(input, other);
  return input;
}

void Mutator::damage(Bytes& bytes, std::span<const std::uint8_t> other) {
  switch (below(6)) {
    case 0:
      return flip_bit(bytes);
    case 1:
      return cut(bytes);
    case 2:
      return repeat(bytes);
    case 3:
      return splice(bytes, other);
    default:
      return overwrite(bytes);
  }
}

void Mutator::flip_bit(Bytes& bytes) {
  const std::size_t bit = below(bytes.size() * 8);
  bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1U << bit % 8);
}

/// Writes a number that code often has at a limit, in 1 to 8 bytes, or a digit over a digit.
void Mutator::overwrite(Bytes& bytes) {
  static constexpr std::array<std::uint64_t, 12> numbers{
      0, 1, 0x7F, 0x80, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7FFFFFFFFFFFFFFF, ~0ULL};
  std::size_t at = below(bytes.size());
  if (bytes[at] >= '0' && bytes[at] <= '9') {
    bytes[at] = static_cast<std::uint8_t>('0' + below(10));
    return;
  }
  std::uint64_t number = numbers[below(numbers.size())];
  for (std::size_t left = std::size_t{1} << below(4); left > 0 && at < bytes.size(); --left, ++at, number >>= 8U) {
    bytes[at] = static_cast<std::uint8_t>(number);
  }
}

void Mutator::cut(Bytes& bytes) {
  const std::size_t at = below(bytes.size());
  const bool end = below(4) == 0;
  const std::size_t count = end ? bytes.size() - at : std::min(1 + below(longest_piece), bytes.size() - at);
  bytes.erase(bytes.begin() + offset(at), bytes.begin() + offset(at + count));
}

void Mutator::repeat(Bytes& bytes) {
  const std::size_t at = below(bytes.size());
  const std::size_t count = std::min(1 + below(longest_piece), bytes.size() - at);
  const Bytes piece(bytes.begin() + offset(at), bytes.begin() + offset(at + count));
  for (std::size_t times = 1 + below(4); times > 0 && bytes.size() + count <= longest_input; --times) {
    bytes.insert(bytes.begin() + offset(at), piece.begin(), piece.end());
  }
}

void Mutator::splice(Bytes& bytes, std::span<const std::uint8_t> other) {
  if (other.empty()) return;
  const std::size_t from = below(other.size()), to = below(bytes.size());
  const std::size_t count = std::min({1 + below(longest_piece), other.size() - from, bytes.size() - to});
  std::ranges::copy(other.subspan(from, count), bytes.begin() + offset(to));
}

}  // namespace throng::fuzz
