#include "app/output/regression/markup.h"

#include <cstddef>
#include <cstdint>

#include "engine/base/text/plain_text.h"

namespace throng::app {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : plain_text(text)) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

std::string in_base64(std::span<const std::byte> bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t group_bytes = 3, group_digits = 4, bits_a_digit = 6;
  std::string text;
  text.reserve((bytes.size() + 2) / group_bytes * group_digits);
  for (std::size_t at = 0; at < bytes.size(); at += group_bytes) {
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < group_bytes; ++i) {
      group = group << 8U | (at + i < bytes.size() ? std::to_integer<std::uint32_t>(bytes[at + i]) : 0U);
    }
    for (std::size_t i = 0; i < group_digits; ++i) {
      const bool is_there = at + i <= bytes.size();  // a group of n bytes has n + 1 digits
      text += is_there ? digits[group >> (bits_a_digit * (group_bytes - i)) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace throng::app
