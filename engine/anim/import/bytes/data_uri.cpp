#include "engine/anim/import/bytes/data_uri.h"

#include <algorithm>
#include <cstdint>

#include "engine/anim/import/bytes/refusal.h"

namespace throng::import {

namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

/// Some exporters break long lines.
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::vector<std::byte> decode_base64(std::string_view text) {
  while (!text.empty() && (text.back() == '=' || is_space(text.back()))) text.remove_suffix(1);
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (const char c : text) {
    if (is_space(c)) continue;
    const int digit = base64_digit(c);
    if (digit < 0) throw Refusal("its data URI is not base64; export the file again");
    bits = (bits << 6U) | static_cast<std::uint32_t>(digit);
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes.push_back(static_cast<std::byte>((bits >> static_cast<unsigned>(bit_count)) & 0xFFU));
  }
  return bytes;
}

std::vector<std::byte> as_bytes(std::string_view text) {
  const auto* from = reinterpret_cast<const std::byte*>(text.data());
  return {from, from + text.size()};
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  constexpr std::string_view scheme = "data:";
  return equal_without_case(uri.substr(0, scheme.size()), scheme);
}

std::vector<std::byte> decode_data_uri(std::string_view uri) {
  constexpr std::string_view base64 = ";base64";
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) throw Refusal("its data URI holds no data; export the file again");
  const std::string_view head = uri.substr(0, comma), data = uri.substr(comma + 1);
  const std::string_view last = head.substr(head.size() - std::min(head.size(), base64.size()));
  if (!equal_without_case(last, base64)) return as_bytes(decode_percent(data));
  return data.find('%') == std::string_view::npos ? decode_base64(data) : decode_base64(decode_percent(data));
}

std::string decode_percent(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size();
    const int high = escape ? hex_digit(text[i + 1]) : -1;
    const int low = escape ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) {
      decoded.push_back(text[i]);
      continue;
    }
    decoded.push_back(static_cast<char>(high * 16 + low));
    i += 2;
  }
  return decoded;
}

bool equal_without_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace throng::import
