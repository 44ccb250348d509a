#include "app/overlay/numbers.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace throng::app {

std::string fixed(double value, int decimals) {
  std::array<char, 64> text = {};
  const int length = std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return {text.data(), static_cast<std::size_t>(std::clamp(length, 0, static_cast<int>(text.size()) - 1))};
}

std::string with_thousands(std::uint64_t value) {
  std::string text = std::to_string(value);
  for (std::size_t end = text.size(); end > 3; end -= 3) text.insert(end - 3, 1, ',');
  return text;
}

std::string as_bytes(std::uint64_t bytes) {
  constexpr double kib = 1024, mib = kib * kib;
  const auto amount = static_cast<double>(bytes);
  if (amount < kib) return std::to_string(bytes) + " B";
  if (amount < mib) return fixed(amount / kib, amount < 100 * kib ? 1 : 0) + " KiB";
  return fixed(amount / mib, amount < 100 * mib ? 1 : 0) + " MiB";
}

std::string as_hex(std::uint64_t value) {
  std::string text(16, '0');
  for (std::size_t digit = text.size(); digit-- > 0; value >>= 4U) text[digit] = "0123456789abcdef"[value & 15U];
  return text;
}

float median(std::vector<float> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace throng::app
