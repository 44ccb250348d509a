#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace throng::soak {

/// A fault that a round found, as a sentence; nothing where all is well.
using Fault = std::optional<std::string>;

/// What a round is given. A round does the same each time that it gets the same seed.
struct RoundPlace {
  std::uint64_t seed = 0;
  std::filesystem::path folder;  ///< empty at its begin, and its own
};

/// Writes a line about what a round does, where the person who waits asked for that (`--tell`).
void tell(const std::string& line);

}  // namespace throng::soak
