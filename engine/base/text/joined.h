#pragma once

#include <concepts>
#include <cstddef>
#include <cstdio>
#include <ranges>
#include <string>
#include <string_view>

namespace throng {

/// Puts `between` between the words, and `last` before the last one: "a, b or c".
template <std::ranges::sized_range Words>
std::string joined(const Words& words, std::string_view between = ", ", std::string_view last = ", ") {
  std::string text;
  auto left = std::ranges::size(words);
  for (const auto& word : words) {
    text += word;
    if (--left > 0) text += left == 1 ? last : between;
  }
  return text;
}

/// Returns a number with `decimals` digits after the point.
inline std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, value);
  return text;
}
inline std::string fixed(std::same_as<float> auto value, int decimals) {
  return fixed(static_cast<double>(value), decimals);
}

/// Returns "1 person" or "7 people".
inline std::string counted_people(std::size_t count) {
  return count == 1 ? "1 person" : std::to_string(count) + " people";
}

/// Returns "1 clip", "2 clips".
inline std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace throng
