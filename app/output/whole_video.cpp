#include "app/output/whole_video.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/base/files/input_file.h"

namespace throng::app {
namespace {

constexpr std::uint64_t webm_head = 0x1A45DFA3, webm_segment = 0x18538067;
constexpr std::uint64_t mp4_table = 0x6D6F6F76, mp4_media = 0x6D646174;  // "moov", "mdat"

/// Returns the whole number in the `count` bytes at a place, the highest byte first. Bytes beyond the end count as 0.
std::uint64_t number_at(InputFile& file, std::uint64_t place, std::size_t count) {
  std::array<std::byte, 8> bytes{};
  if (file.go_to(place)) static_cast<void>(file.read(std::span(bytes).first(count)));
  std::uint64_t number = 0;
  for (const std::byte byte : std::span(bytes).first(count)) {
    number = number << 8U | std::to_integer<std::uint64_t>(byte);
  }
  return number;
}

/// Returns where the part of a .webm ends whose length stands at a place: the zeros before the length's first one tell
/// how many bytes it has.
std::uint64_t webm_end(InputFile& file, std::uint64_t place) {
  const auto zeros = static_cast<std::size_t>(std::countl_zero(static_cast<std::uint8_t>(number_at(file, place, 1))));
  const std::size_t count = std::min<std::size_t>(zeros + 1, 8);
  return place + count + (number_at(file, place, count) & ((std::uint64_t{1} << 7U * count) - 1));
}

bool is_whole_webm(InputFile& file) {
  const std::uint64_t segment = webm_end(file, 4);
  return number_at(file, segment, 4) == webm_segment && webm_end(file, segment + 4) == file.size();
}

bool is_whole_mp4(InputFile& file) {
  constexpr std::uint64_t least = 8;
  bool has_table = false, has_media = false;
  for (std::uint64_t place = 0, length = 0; place < file.size(); place += length) {
    length = number_at(file, place, 4);
    if (length == 1) length = number_at(file, place + 8, 8);  // too long for 4 bytes
    if (length < least || length > file.size() - place) return false;
    const std::uint64_t name = number_at(file, place + 4, 4);
    has_table |= name == mp4_table;
    has_media |= name == mp4_media;
  }
  return has_table && has_media;
}

}  // namespace

bool is_whole_video(const std::filesystem::path& file) {
  auto video = InputFile::open(file);
  if (!video) return false;
  return number_at(*video, 0, 4) == webm_head ? is_whole_webm(*video) : is_whole_mp4(*video);
}

}  // namespace throng::app
