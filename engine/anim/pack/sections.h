#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/anim/base/aligned_bytes.h"
#include "engine/base/result.h"

namespace throng::pack {

/// The contents of a section.
enum class SectionKind : std::uint32_t {
  file,           ///< the name of a file, and what import said of it
  model,          ///< one of its models, as imported, without clips
  clips,          ///< the model's clips with all keys; may be absent
  character,      ///< the baked model, its streams used in place
  surveyed_keys,  ///< the clips with those keys alone that another order of bones is measured by
  surface,        ///< the model's surface for the device, written and read by the renderer
};

/// One row of the table of sections.
///
///      0       4      8       12       16       24
///     | kind  | file | model | unused | offset | size |
struct Section {
  SectionKind kind;
  std::uint32_t file;   ///< counts the files that were baked into the pack
  std::uint32_t model;  ///< counts the models of the file
  std::uint32_t unused;
  std::uint64_t offset;  ///< bytes from the start of the pack, a multiple of 64
  std::uint64_t size;    ///< bytes
};
static_assert(sizeof(Section) == 32);
static_assert(offsetof(Section, offset) == 16);

/// Begins a pack, which is one relocatable image:
///
///     PackHeader | Section x section_count | section | section | ... each from a multiple of 64 bytes
///
///      0       8            12        16       24     32         40              44       48
///     | magic | byte_order | version | layout | size | checksum | section_count | unused |
struct alignas(64) PackHeader {
  char magic[8];
  std::uint32_t byte_order;  ///< byte_order_mark, as the machine writes it that bakes
  std::uint32_t version;     ///< pack_version
  std::uint64_t layout;      ///< the form of all tables, and of the blocks in them
  std::uint64_t size;        ///< bytes of the pack
  std::uint64_t checksum;    ///< XXH3 of all bytes, with 0 here
  std::uint32_t section_count;
  std::uint32_t unused[5];
};
static_assert(sizeof(PackHeader) == 64);
static_assert(offsetof(PackHeader, byte_order) == 8);
static_assert(offsetof(PackHeader, checksum) == 32);
static_assert(offsetof(PackHeader, section_count) == 40);

/// Rounds a size up to where a section or a block may begin.
constexpr std::size_t block_after(std::size_t size) {
  return (size + anim::block_alignment - 1) / anim::block_alignment * anim::block_alignment;
}

/// Raise it when the meaning of bytes changes while their layout stays.
inline constexpr std::uint32_t pack_version = 6;

/// Returns the XXH3 of bytes that follow others, whose checksum `before` is.
std::uint64_t checksum_of(std::span<const std::byte> bytes, std::uint64_t before);

/// A section to be written.
struct SectionBytes {
  SectionKind kind;
  std::uint32_t file;
  std::uint32_t model;
  std::span<const std::byte> bytes;
};

/// Returns a pack of these sections. `layout` is the layout of their tables.
std::vector<std::byte> join_sections(std::span<const SectionBytes> sections, std::uint64_t layout,
                                     std::uint32_t version = pack_version);

/// Says whether bytes begin as a pack does.
bool begins_a_pack(std::string_view bytes);

/// Checks every byte of a pack, and returns the table of its sections, which lie within it. `pack` is 64-byte aligned.
/// The error names its fault and what to do, without its name.
Result<std::span<const Section>> check_sections(std::span<const std::byte> pack, std::uint64_t layout);

}  // namespace throng::pack
