#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace throng {

/// Draws the same numbers on every machine for the same seed and stream (PCG32, M. O'Neill 2014); distributions of
/// `std` do not.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream) : increment_((stream << 1U) | 1U) {
    next();
    state_ += seed;
    next();
  }

  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (shifted >> turn) | (shifted << ((32U - turn) & 31U));
  }

  /// Draws a number from 0 to below 1, in steps of 2^-24.
  float unit() { return static_cast<float>(next() >> 8U) * 0x1p-24F; }
  float between(float low, float high) { return low + (high - low) * unit(); }
  /// Draws a number from 0 to below `count`, which is above 0.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(next()) * count) >> 32U);
  }
  bool chance(float probability) { return unit() < probability; }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

/// Puts elements into a random order.
template <typename Element>
void put_in_random_order(std::vector<Element>& elements, Random& random) {
  for (std::size_t left = elements.size(); left > 1; --left) {
    std::swap(elements[left - 1], elements[random.below(static_cast<std::uint32_t>(left))]);
  }
}

}  // namespace throng
