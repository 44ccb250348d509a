#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace throng::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// Damages inputs at random. The same seed and the same calls give the same bytes on every machine.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : state_(seed) {}

  /// Returns `input` with 1 to 4 damages: a bit, a number, a piece left out, repeated, or taken from `other`.
  Bytes damaged(Bytes input, std::span<const std::uint8_t> other);

 private:
  std::uint64_t next();
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  void damage(Bytes& bytes, std::span<const std::uint8_t> other);
  void flip_bit(Bytes& bytes);
  void overwrite(Bytes& bytes);
  void cut(Bytes& bytes);
  void repeat(Bytes& bytes);
  void splice(Bytes& bytes, std::span<const std::uint8_t> other);

  std::uint64_t state_;
};

}  // namespace throng::fuzz
