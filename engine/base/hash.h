#pragma once

#include <cstdint>

namespace throng {

/// Mixes 64 bits, bijectively (the finaliser of splitmix64): every input bit changes half of the output bits.
constexpr std::uint64_t mix_bits(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31);
}

/// Chains `next` to the hash of all values before it. The order matters.
constexpr std::uint64_t chain_hash(std::uint64_t before, std::uint64_t next) {
  return mix_bits(before * 0x9e3779b97f4a7c15ULL + next + 1);
}

}  // namespace throng
