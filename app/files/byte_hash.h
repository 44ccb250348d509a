#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "engine/base/hash.h"

namespace throng::app {

/// Hashes many bytes. Pieces of any size give the same hash. It chains each eight bytes as a little-endian number, then
/// the rest with zeros behind it, then the count of all.
class ByteHash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) {
      word_ |= std::uint64_t{static_cast<unsigned char>(byte)} << count_ % 8 * 8;
      if (++count_ % 8 != 0) continue;
      hash_ = chain_hash(hash_, word_);
      word_ = 0;
    }
  }

  std::uint64_t value() const { return chain_hash(chain_hash(hash_, word_), count_); }

 private:
  std::uint64_t hash_ = 0;
  std::uint64_t word_ = 0;  // up to seven bytes that are not in `hash_` yet
  std::uint64_t count_ = 0;
};

/// Returns 16 hexadecimal digits.
inline std::string hex_string(std::uint64_t bits) {
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(bits));
  return text;
}

}  // namespace throng::app
