#include "engine/anim/import/source_file.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/other_formats.h"
#include "engine/base/files/input_file.h"

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

/// A document is an object. It may begin with a byte order mark.
bool looks_like_json(std::string_view text) {
  const std::size_t begin = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  return begin != std::string_view::npos && text[begin] == '{';
}

}  // namespace

FileParts split_file(std::span<const std::byte> bytes, const std::filesystem::path& path) {
  if (bytes.empty()) throw Refusal("it is empty; export the file again");
  if (bytes.size() >= 4 && read_word(bytes, 0) == magic) return split_glb(bytes);
  if (!looks_like_json(as_text(bytes))) {
    if (const std::string other = describe_other_format(bytes, path); !other.empty()) throw Refusal(other);
  }
  return {.json = as_text(bytes), .binary = std::nullopt};
}

std::vector<std::byte> read_file(const std::filesystem::path& path) {
  auto bytes = throng::read_file(path, "a .glb or .gltf", max_file_size);
  if (!bytes) throw Refusal(bytes.error().message);
  return std::move(*bytes);
}

}  // namespace throng::import
