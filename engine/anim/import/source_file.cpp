#include "engine/anim/import/source_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

constexpr std::uint32_t magic = 0x46546C67;       // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t binary_chunk = 0x004E4942;
constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;

std::uint32_t read_word(std::span<const std::byte> bytes, std::size_t offset) {
  std::array<std::uint8_t, 4> raw{};
  std::memcpy(raw.data(), bytes.data() + offset, raw.size());
  return raw[0] | (std::uint32_t{raw[1]} << 8U) | (std::uint32_t{raw[2]} << 16U) | (std::uint32_t{raw[3]} << 24U);
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
  std::uint32_t type = 0;
  std::span<const std::byte> bytes;
};

/// Takes the first chunk off `rest`.
Chunk take_chunk(std::span<const std::byte>& rest) {
  if (rest.size() < chunk_header_size) throw Refusal("its GLB container is cut short; copy or export the file again");
  const std::size_t length = read_word(rest, 0);
  const Chunk chunk{.type = read_word(rest, 4), .bytes = rest.subspan(chunk_header_size)};
  if (length > chunk.bytes.size()) {
    throw Refusal("a chunk of its GLB container says " + std::to_string(length) + " bytes, but " +
                  std::to_string(chunk.bytes.size()) + " are left; copy or export the file again");
  }
  rest = chunk.bytes.subspan(length);
  return {.type = chunk.type, .bytes = chunk.bytes.first(length)};
}

FileParts split_glb(std::span<const std::byte> bytes) {
  if (bytes.size() < header_size) throw Refusal("its GLB header is cut short; copy or export the file again");
  if (const auto version = read_word(bytes, 4); version != 2) {
    throw Refusal("its GLB container has version " + std::to_string(version) + ", not 2; export it as glTF 2.0");
  }
  const std::size_t length = read_word(bytes, 8);
  if (length < header_size + chunk_header_size) {
    throw Refusal("its GLB header says " + std::to_string(length) + " bytes, too few for any chunk; export it again");
  }
  if (length > bytes.size()) {
    throw Refusal("its GLB header says " + std::to_string(length) + " bytes, but the file has " +
                  std::to_string(bytes.size()) + "; copy or export the file again");
  }
  auto rest = bytes.subspan(header_size, length - header_size);
  const Chunk json = take_chunk(rest);
  if (json.type != json_chunk) throw Refusal("the first chunk of its GLB container is not JSON; export the file again");
  FileParts parts{.json = as_text(json.bytes), .binary = std::nullopt};
  if (!rest.empty()) {
    const Chunk binary = take_chunk(rest);
    if (binary.type == binary_chunk) parts.binary = binary.bytes;
  }
  return parts;
}

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

FileParts split_file(std::span<const std::byte> bytes) {
  if (bytes.empty()) throw Refusal("it is empty; export the file again");
  if (bytes.size() >= 4 && read_word(bytes, 0) == magic) return split_glb(bytes);
  return {.json = as_text(bytes), .binary = std::nullopt};
}

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
