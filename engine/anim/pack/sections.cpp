#include "engine/anim/pack/sections.h"

#include <algorithm>
#include <cstring>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace throng::pack {
namespace {

// The first byte is no text, and the last one shows whether line ends were converted, as in a PNG.
constexpr char pack_magic[8] = {'\x89', 'T', 'H', 'R', 'O', 'N', 'G', '\n'};
constexpr std::uint32_t byte_order_mark = 0x01020304;
constexpr std::uint32_t other_byte_order = 0x04030201;

/// Hashes all bytes of a pack as if its checksum were 0.
std::uint64_t checksum(const PackHeader& header, std::span<const std::byte> pack) {
  PackHeader without = header;
  without.checksum = 0;
  const std::uint64_t start = XXH3_64bits(&without, sizeof without);
  return checksum_of(pack.subspan(sizeof header), start);
}

Error refusal(const std::string& what) { return {what + "; bake it again"}; }

/// Other machines and versions put these members in the same places, so that they can be told apart from damage.
Status check_whole(const PackHeader& header, std::span<const std::byte> pack) {
  if (header.byte_order == other_byte_order) return refusal("it was baked for machines of the other byte order");
  if (pack.size() < header.size) {
    return refusal("it is cut short: " + std::to_string(pack.size()) + " bytes of " + std::to_string(header.size));
  }
  if (header.checksum != checksum(header, pack)) return refusal("it is damaged: its checksum does not fit");
  return Done{};
}

Status check_version(const PackHeader& header, std::uint64_t layout) {
  if (header.version != pack_version) {
    return refusal("it was baked by another version of throng (its form is number " + std::to_string(header.version) +
                   ", this one reads number " + std::to_string(pack_version) + ")");
  }
  if (header.layout != layout) return refusal("it was baked by another version of throng, whose tables differ");
  return Done{};
}

bool lies_within(const Section& section, std::size_t first, std::size_t size) {
  return section.offset % anim::block_alignment == 0 && section.offset >= first && section.offset <= size &&
         section.size <= size - section.offset;
}

}  // namespace

std::uint64_t checksum_of(std::span<const std::byte> bytes, std::uint64_t before) {
  return XXH3_64bits_withSeed(bytes.data(), bytes.size(), before);
}

std::vector<std::byte> join_sections(std::span<const SectionBytes> sections, std::uint64_t layout,
                                     std::uint32_t version) {
  std::vector<Section> table;
  std::size_t end = block_after(sizeof(PackHeader) + sections.size() * sizeof(Section));
  for (const SectionBytes& section : sections) {
    table.push_back({section.kind, section.file, section.model, 0, end, section.bytes.size()});
    end = block_after(end + section.bytes.size());
  }
  std::vector<std::byte> pack(end);
  std::ranges::copy(std::as_bytes(std::span(table)), pack.begin() + sizeof(PackHeader));
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::ranges::copy(sections[i].bytes, pack.begin() + static_cast<std::ptrdiff_t>(table[i].offset));
  }
  PackHeader header{};
  std::ranges::copy(pack_magic, header.magic);
  header.byte_order = byte_order_mark;
  header.version = version;
  header.layout = layout;
  header.size = pack.size();
  header.section_count = static_cast<std::uint32_t>(table.size());
  header.checksum = checksum(header, pack);
  std::memcpy(pack.data(), &header, sizeof header);
  return pack;
}

bool begins_a_pack(std::string_view bytes) {
  return bytes.starts_with(std::string_view(pack_magic, sizeof pack_magic));
}

Result<std::span<const Section>> check_sections(std::span<const std::byte> pack, std::uint64_t layout) {
  const std::string_view text(reinterpret_cast<const char*>(pack.data()), pack.size());
  if (!begins_a_pack(text)) return refusal("it is no pack, or its first bytes are damaged");
  if (pack.size() < sizeof(PackHeader)) return refusal("it is cut short");
  PackHeader header;
  std::memcpy(&header, pack.data(), sizeof header);
  if (const Status whole = check_whole(header, pack); !whole) return whole.error();
  if (const Status fits = check_version(header, layout); !fits) return fits.error();
  const std::size_t sections_end = sizeof(PackHeader) + std::size_t{header.section_count} * sizeof(Section);
  if (sections_end > pack.size()) return refusal("it is damaged: its table of sections does not fit in it");
  const std::span<const Section> sections(reinterpret_cast<const Section*>(pack.data() + sizeof(PackHeader)),
                                          header.section_count);
  const auto is_sound = [&](const Section& section) { return lies_within(section, sections_end, pack.size()); };
  if (!std::ranges::all_of(sections, is_sound)) return refusal("it is damaged: a section lies outside of it");
  return sections;
}

}  // namespace throng::pack
