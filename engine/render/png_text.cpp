#include "throng/render/png_text.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/base/files/input_file.h"

namespace throng::render {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t most_text_bytes = 4096;  // of a chunk; longer ones are of others

struct ChunkHead {
  std::uint32_t length = 0;
  std::string type;
};

std::optional<std::string> read_bytes(InputFile& file, std::size_t count) {
  std::string bytes(count, '\0');
  const auto read = file.read(std::as_writable_bytes(std::span(bytes)));
  return read && *read == count ? std::optional(bytes) : std::nullopt;
}

std::optional<ChunkHead> read_head(InputFile& file) {
  constexpr std::size_t length_bytes = 4, type_bytes = 4;
  const auto bytes = read_bytes(file, length_bytes + type_bytes);
  if (!bytes) return {};
  ChunkHead head{.length = 0, .type = bytes->substr(length_bytes)};
  for (std::size_t i = 0; i < length_bytes; ++i) {
    head.length = head.length << 8U | static_cast<std::uint8_t>((*bytes)[i]);
  }
  return head;
}

}  // namespace

Result<std::vector<PngText>> read_png_texts(const std::filesystem::path& file) {
  constexpr std::size_t checksum_bytes = 4;
  auto opened = InputFile::open(file, "a .png");
  if (!opened) return Error{file.string() + ": " + opened.error().message};
  if (read_bytes(*opened, signature.size()) != signature) return Error{file.string() + ": it is no PNG"};
  std::vector<PngText> texts;
  std::uint64_t place = signature.size();
  for (auto head = read_head(*opened); head && head->type != "IDAT" && head->type != "IEND";
       head = read_head(*opened)) {
    constexpr std::size_t head_bytes = 8;
    if (head->type == "tEXt" && head->length <= most_text_bytes) {
      const auto bytes = read_bytes(*opened, head->length);
      if (!bytes) break;
      const std::size_t end = bytes->find('\0');
      if (end != std::string::npos) texts.push_back({bytes->substr(0, end), bytes->substr(end + 1)});
    }
    place += head_bytes + head->length + checksum_bytes;
    if (place >= opened->size() || !opened->go_to(place)) break;
  }
  return texts;
}

}  // namespace throng::render
