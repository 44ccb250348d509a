#pragma once

#include <algorithm>
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

/// Returns a number with a comma before each three digits of its whole part: "-12,345.50".
inline std::string with_thousands(std::string number) {
  const std::size_t first = number.starts_with('-') ? 1 : 0;
  for (std::size_t end = std::min(number.find('.'), number.size()); end > first + 3; end -= 3) {
    number.insert(end - 3, 1, ',');
  }
  return number;
}
inline std::string with_thousands(std::integral auto value) { return with_thousands(std::to_string(value)); }

/// Returns "1 person" or "7 people".
inline std::string counted_people(std::size_t count) {
  return count == 1 ? "1 person" : with_thousands(count) + " people";
}

/// Returns "1 clip", "2 clips".
inline std::string counted(std::size_t count, const std::string& thing) {
  return with_thousands(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace throng
