#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace throng::soak {

/// A fault that a round found, as a sentence; nothing where all is well.
using Fault = std::optional<std::string>;

/// Tells a round what to draw its acts from, and where to work. It does the same each time that it gets the same seed.
struct RoundPlace {
  std::uint64_t seed = 0;
  std::filesystem::path folder;  ///< empty at its begin, and its own
};

/// Counts how often rounds did each thing.
using Counts = std::map<std::string, int>;
/// Returns a line for each: who did it, what, and how often.
std::string table_of(const std::string& who, const Counts& counts);

inline constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

/// Writes a line about what a round does, where the person who waits asked for that (`--tell`).
void tell(const std::string& line);

}  // namespace throng::soak
