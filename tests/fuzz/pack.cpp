// Packs: the bytes as they are, and their sections in a pack whose header and checksum are true. Only the first is
// asked for all that a pack can do, because whoever makes a true checksum is trusted.

#include "engine/anim/pack/pack.h"

#include <cstring>

#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

namespace throng::fuzz {
namespace {

std::uint64_t layout_of_packs() {
  const std::vector<std::byte> none = pack::write_pack({});
  pack::PackHeader header;
  std::memcpy(&header, none.data(), sizeof header);
  return header.layout;
}

/// Returns a pack of those sections of the input that lie within it.
std::vector<std::byte> with_true_header(std::span<const std::byte> input) {
  static const std::uint64_t layout = layout_of_packs();
  std::vector<pack::SectionBytes> sections;
  for (std::size_t at = sizeof(pack::PackHeader); at + sizeof(pack::Section) <= input.size();
       at += sizeof(pack::Section)) {
    pack::Section section;
    std::memcpy(&section, input.data() + at, sizeof section);
    if (section.offset > input.size() || section.size > input.size() - section.offset || sections.size() == 64) break;
    sections.push_back({section.kind, section.file, section.model, input.subspan(section.offset, section.size)});
  }
  return pack::join_sections(sections, layout);
}

void read_tables(const pack::Pack& pack) {
  for (std::size_t file = 0; file < pack.file_count(); ++file) {
    static_cast<void>(pack.imported(file));
    for (std::size_t model = 0; model < pack.names(file).size(); ++model) {
      static_cast<void>(pack.baked(file, model));
      static_cast<void>(pack.surface(file, model));
    }
  }
}

void read_models(const pack::Pack& pack) {
  for (std::size_t file = 0; file < pack.file_count(); ++file) {
    for (std::size_t model = 0; model < pack.names(file).size(); ++model) {
      if (const auto baked = pack.baked(file, model)) static_cast<void>(pack.model(file, model, *baked));
    }
  }
}

}  // namespace
}  // namespace throng::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  static const fuzz::ScratchFile file("input.pack");
  file.put(data, size);
  if (const auto pack = pack::Pack::open(file.path())) {
    fuzz::read_tables(*pack);
    fuzz::read_models(*pack);
  }
  file.put(fuzz::with_true_header(std::as_bytes(std::span(data, size))));
  if (const auto pack = pack::Pack::open(file.path())) fuzz::read_tables(*pack);
  return 0;
}
