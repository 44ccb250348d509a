#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <system_error>

namespace throng::app {

/// Reads the number at the front of [at, end), with a sign or without. Returns the number's end; null if there is none,
/// or if it is too large for a double. The number is the nearest double to the text, as std::from_chars gives it.
inline const char* read_number(const char* at, const char* end, double& value) {
  static constexpr std::array<double, 19> tens{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                               1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};
  const char* digit = at;
  const bool is_signed = digit < end && (*digit == '-' || *digit == '+');
  if (is_signed) ++digit;
  const bool is_negative = is_signed && *at == '-';
  const auto is_digit = [&] { return digit < end && *digit >= '0' && *digit <= '9'; };
  std::uint64_t digits = 0;
  const char* const first = digit;
  for (; is_digit(); ++digit) digits = digits * 10 + static_cast<std::uint64_t>(*digit - '0');
  std::ptrdiff_t count = digit - first, after_point = 0;
  if (digit < end && *digit == '.') {
    const char* const point = digit++;
    for (; is_digit(); ++digit) digits = digits * 10 + static_cast<std::uint64_t>(*digit - '0');
    after_point = digit - point - 1;
    count += after_point;
  }
  const bool goes_on = digit < end && (*digit == 'e' || *digit == 'E');
  // A quotient of two numbers that are exact is the nearest double.
  if (count > 0 && count <= 18 && digits <= (std::uint64_t{1} << 53U) && !goes_on) {
    const double quotient = static_cast<double>(digits) / tens[static_cast<std::size_t>(after_point)];
    value = is_negative ? -quotient : quotient;
    return digit;
  }
  if (is_signed && (first == end || *first == '-' || *first == '+')) return nullptr;
  const auto [stop, error] = std::from_chars(is_negative ? at : first, end, value);
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

}  // namespace throng::app
