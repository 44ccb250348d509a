#include "assets/making/glb_container.h"

#include <bit>
#include <cstdint>
#include <string>

namespace throng::making {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian");

void append_word(std::vector<std::byte>& bytes, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  const auto raw = std::as_bytes(std::span(&word, 1));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

void append_chunk(std::vector<std::byte>& bytes, std::span<const std::byte> chunk, std::uint32_t type) {
  append_word(bytes, chunk.size());
  append_word(bytes, type);
  bytes.insert(bytes.end(), chunk.begin(), chunk.end());
}

}  // namespace

std::vector<std::byte> glb_container(const Json& document, std::span<const std::byte> buffer) {
  constexpr std::uint32_t magic = 0x46546C67;  // "glTF"
  constexpr std::uint32_t json_chunk = 0x4E4F534A;
  constexpr std::uint32_t binary_chunk = 0x004E4942;
  std::string text = document.dump();
  while (text.size() % 4 != 0) text.push_back(' ');
  std::vector<std::byte> file;
  append_word(file, magic);
  append_word(file, 2);
  append_word(file, 12 + 8 + text.size() + 8 + buffer.size());
  append_chunk(file, std::as_bytes(std::span(text)), json_chunk);
  append_chunk(file, buffer, binary_chunk);
  return file;
}

}  // namespace throng::making
