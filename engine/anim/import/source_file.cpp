#include "engine/anim/import/source_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <system_error>

#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

constexpr std::size_t max_uri_length = 1024;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string decode_percent(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      text.push_back(uri[i]);
      continue;
    }
    const int high = i + 1 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = i + 2 < uri.size() ? hex_digit(uri[i + 2]) : -1;
    if (high < 0 || low < 0) throw Refusal("its uri has a stray percent sign; write it as %25");
    text.push_back(static_cast<char>(high * 16 + low));
    i += 2;
  }
  return text;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::vector<std::byte> decode_base64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (const char c : text) {
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

bool is_below(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const auto [in_folder, in_file] = std::ranges::mismatch(folder, file);
  return in_folder == folder.end() && in_file != file.end();
}

}  // namespace

std::vector<std::byte> read_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw Refusal("there is no such file; check the path");
  if (!std::filesystem::is_regular_file(status)) throw Refusal("it is not a regular file; name a .glb or .gltf");
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw Refusal("its size cannot be read: " + error.message());
  if (size > max_file_size) throw Refusal("it is larger than 1 GiB; split the model");
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()))) {
    throw Refusal("it cannot be read; check its permissions");
  }
  return bytes;
}

std::filesystem::path resolve_uri(const std::filesystem::path& folder, std::string_view uri) {
  if (uri.empty()) throw Refusal("its uri is empty; name a file beside the model");
  if (uri.size() > max_uri_length) throw Refusal("its uri is longer than 1024 characters; rename the file");
  const std::string text = decode_percent(uri);
  if (text.find('\0') != std::string::npos) throw Refusal("its uri holds a zero byte; rename the file");
  if (text.find(':') != std::string::npos || text.find('\\') != std::string::npos || text.front() == '/') {
    throw Refusal("its uri is not a plain relative path; keep its files beside the model");
  }
  const std::filesystem::path relative(text);
  if (std::ranges::find(relative, "..") != relative.end()) {
    throw Refusal("its uri leaves the model's folder; keep its files beside the model");
  }
  std::error_code error;
  const auto root = std::filesystem::canonical(folder.empty() ? "." : folder, error);
  const auto file = std::filesystem::weakly_canonical(root / relative, error);
  if (!error && file == root) throw Refusal("its uri names the model's folder; name a file beside the model");
  if (error || !is_below(root, file)) {
    throw Refusal("its uri leaves the model's folder; keep its files beside the model");
  }
  return file;
}

std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri) {
  if (!uri.starts_with("data:")) return std::nullopt;
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) throw Refusal("its data URI holds no data; export the file again");
  if (!uri.substr(0, comma).ends_with(";base64")) throw Refusal("its data URI is not base64; export the file again");
  return decode_base64(uri.substr(comma + 1));
}

}  // namespace throng::import
