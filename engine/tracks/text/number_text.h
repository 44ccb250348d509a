#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace throng {

/// Reads the number at the front of [at, end), with a sign or without. Returns its end; null if there is none, or if it
/// is too large for a double.
inline const char* read_number(const char* at, const char* end, double& value) {
  const char* const first = at < end && *at == '+' ? at + 1 : at;
  if (first != at && first < end && *first == '-') return nullptr;
  const auto [stop, error] = std::from_chars(first, end, value);
  return error == std::errc() ? stop : nullptr;
}

/// Reads a text; returns whether it is a number and nothing else, apart from blanks around it.
inline bool is_number_text(std::string_view text, double& value) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return !text.empty() && read_number(text.data(), text.data() + text.size(), value) == text.data() + text.size();
}

/// Reads a number with a comma in place of the point: "1,5".
inline bool is_decimal_comma_text(std::string_view text, double& value) {
  std::array<char, 40> pointed;
  if (text.size() > pointed.size() || text.find('.') != std::string_view::npos) return false;
  char* const end = std::ranges::replace_copy(text, pointed.begin(), ',', '.').out;
  return is_number_text({pointed.data(), end}, value);
}

/// Returns an id without a fraction of zeros, which programs that write only numbers add: 1.0e+00 is 1. The view is
/// into `id` or `digits`.
inline std::string_view plain_id(std::string_view id, std::array<char, 32>& digits) {
  double number = 0.0;
  const bool is_whole = id.find('.') != std::string_view::npos && is_number_text(id, number) &&
                        std::abs(number) < 1e15 && number == std::floor(number);
  if (!is_whole) return id;
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), std::llround(number)).ptr;
  return {digits.data(), static_cast<std::size_t>(end - digits.data())};
}

}  // namespace throng
