#include "engine/anim/pack/pack.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>
#include <string_view>

#include "engine/anim/asset/placement.h"
#include "engine/anim/base/pose.h"
#include "engine/anim/pack/tables.h"
#include "engine/anim/survey/lod_survey.h"
#include "engine/base/files/input_file.h"
#include "engine/base/text/plain_text.h"

namespace throng::pack {

template <typename Archive, Same<Preparation> T>
void describe(Archive& archive, T& prepared) {
  archive(prepared.placement, prepared.order);
}

namespace {

/// Returns the form of all tables, and of the blocks and lanes in them.
std::uint64_t layout_of_tables() {
  static const std::uint64_t hash = [] {
    PackLayout layout;
    anim::ImportedFile file;
    anim::Model model;
    std::vector<anim::Clip> clips;
    const BakedModel baked;
    layout(file, model, clips, baked.prepared, baked.ragdoll, baked.character);
    layout.note('t', anim::packet_bones);
    layout.note('e', sizeof(anim::KeyEvent));
    layout.note('p', sizeof(anim::SampledPacket));
    return layout.hash();
  }();
  return hash;
}

/// The tables of a pack, which its sections point into until it is joined.
class Tables {
 public:
  template <typename... Values>
  void add(SectionKind kind, std::size_t file, std::size_t model, const Values&... values) {
    PackWriter writer;
    writer(values...);
    entries_.push_back({kind, static_cast<std::uint32_t>(file), static_cast<std::uint32_t>(model), writer.bytes()});
  }
  void add_bytes(SectionKind kind, std::size_t file, std::size_t model, const std::vector<std::byte>& bytes) {
    entries_.push_back({kind, static_cast<std::uint32_t>(file), static_cast<std::uint32_t>(model), bytes});
  }
  std::vector<std::byte> join() const {
    std::vector<SectionBytes> sections;
    for (const Entry& entry : entries_) sections.push_back({entry.kind, entry.file, entry.model, entry.bytes});
    return join_sections(sections, layout_of_tables());
  }

 private:
  struct Entry {
    SectionKind kind;
    std::uint32_t file, model;
    std::vector<std::byte> bytes;
  };
  std::vector<Entry> entries_;
};

std::vector<anim::Clip> with_surveyed_keys(const anim::Model& model) {
  anim::Model surveyed;
  surveyed.clips = model.clips;
  anim::keep_surveyed_keys(surveyed);
  return std::move(surveyed.clips);
}

void add_file(const FileToPack& packed, std::size_t file, Tables& tables) {
  assert(!packed.characters.empty() && packed.characters.size() <= packed.file.models.size());
  const auto models = static_cast<std::uint32_t>(packed.file.models.size());
  std::vector<std::string> names;
  for (const CharacterToPack& character : packed.characters) names.push_back(character.name);
  tables.add(SectionKind::file, file, 0, packed.name, models, names, packed.made_of, packed.file);
  for (std::size_t i = 0; i < packed.characters.size(); ++i) {
    const CharacterToPack& character = packed.characters[i];
    tables.add(SectionKind::character, file, i, character.prepared, character.ragdoll, *character.character);
    tables.add(SectionKind::surveyed_keys, file, i, with_surveyed_keys(packed.file.models[i]));
    tables.add_bytes(SectionKind::surface, file, i, character.surface);
  }
  for (std::size_t i = 0; i < packed.file.models.size(); ++i) {
    tables.add(SectionKind::model, file, i, packed.file.models[i]);
    if (packed.with_keys) tables.add(SectionKind::clips, file, i, packed.file.models[i].clips);
  }
}

/// Reads all of a file into memory that is aligned as a mapping is.
Result<MappedFile> copy_file(const std::filesystem::path& path, std::string_view wanted) {
  auto file = InputFile::open(path, wanted);
  if (!file) return file.error();
  const auto size = static_cast<std::size_t>(file->size());
  const auto copy = std::make_shared<anim::AlignedBytes>(anim::allocate_aligned(size));
  const auto read = file->read({copy->get(), size});
  if (!read) return read.error();
  return MappedFile{.bytes = {copy->get(), *read}, .owner = copy};
}

bool is_pack(std::string_view name, std::string_view start) { return name.ends_with(".pack") || begins_a_pack(start); }

}  // namespace

std::vector<std::byte> write_pack(std::span<const FileToPack> files) {
  Tables tables;
  for (std::size_t file = 0; file < files.size(); ++file) add_file(files[file], file, tables);
  return tables.join();
}

Result<std::uint64_t> fingerprint_of(std::span<const std::string> files) {
  std::uint64_t fingerprint = 0;
  for (const std::string& file : files) {
    const auto copy = copy_file(file, "a file to bake");
    if (!copy) return Error{plain_text(file) + ": " + copy.error().message};
    fingerprint = checksum_of(copy->bytes, fingerprint);
  }
  return fingerprint;
}

bool is_pack(const std::string& path) {
  std::array<char, 8> start{};
  auto file = InputFile::open(path);
  if (!file || !file->read(std::as_writable_bytes(std::span(start)))) return false;
  return is_pack(path, {start.data(), start.size()});
}

bool is_pack(const FileInMemory& file) {
  return is_pack(file.name, {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
}

Result<Pack> Pack::open(const std::string& path, PackBytes bytes) {
  return of_bytes(path, (bytes == PackBytes::mapped ? map_file : copy_file)(path, "a .pack"));
}

Result<Pack> Pack::open(const FileInMemory& file) {
  const auto copy = std::make_shared<anim::AlignedBytes>(anim::allocate_aligned(file.bytes.size()));
  std::ranges::copy(file.bytes, copy->get());
  return of_bytes(std::string(file.name), MappedFile{.bytes = {copy->get(), file.bytes.size()}, .owner = copy});
}

Result<Pack> Pack::of_bytes(const std::string& path, Result<MappedFile> taken) {
  Pack pack(plain_text(path));
  const auto refused = [&](const Error& why) { return Error{pack.path_ + ": " + why.message}; };
  if (!taken) return refused(taken.error());
  const auto sections = check_sections(taken->bytes, layout_of_tables());
  if (!sections) return refused(sections.error());
  pack.bytes_ = taken->bytes;
  pack.lender_ = std::move(taken->owner);
  pack.sections_ = *sections;
  if (const Status read = pack.read_files(); !read) return read.error();
  return pack;
}

Status Pack::read_files() {
  const auto files = std::ranges::count(sections_, SectionKind::file, &Section::kind);
  if (files == 0) return damaged();
  for (std::size_t file = 0; file < static_cast<std::size_t>(files); ++file) {
    PackedFile& packed = files_.emplace_back();
    Status taken =
        read(SectionKind::file, file, 0, packed.name, packed.models, packed.names, packed.made_of, packed.header);
    if (!taken) return taken;
    packed.header.file = path_;
    if (packed.names.empty() || packed.names.size() > packed.models) return damaged();
  }
  return Done{};
}

std::span<const std::byte> Pack::section(SectionKind kind, std::size_t file, std::size_t model) const {
  for (const Section& section : sections_) {
    if (section.kind != kind || section.file != file || section.model != model) continue;
    return bytes_.subspan(section.offset, section.size);
  }
  return {};
}

template <typename... Values>
Status Pack::read(SectionKind kind, std::size_t file, std::size_t model, Values&... values) const {
  PackReader reader(section(kind, file, model), lender_);
  reader(values...);
  return reader.read_all() ? Status(Done{}) : damaged();
}

Error Pack::damaged() const { return {path_ + ": it is damaged: its tables do not fit together; bake it again"}; }

Result<BakedModel> Pack::baked(std::size_t file, std::size_t model) const {
  BakedModel baked;
  const Status taken = read(SectionKind::character, file, model, baked.prepared, baked.ragdoll, baked.character);
  if (!taken) return taken.error();
  if (anim::fault_of(baked.character) != nullptr) return damaged();
  baked.character.lender = lender_;
  return baked;
}

Result<anim::Character> Pack::character(std::size_t file, std::size_t model) const {
  Result<BakedModel> taken = baked(file, model);
  if (!taken) return taken.error();
  return std::move(taken->character);
}

Result<anim::Model> Pack::model(std::size_t file, std::size_t model, const BakedModel& baked) const {
  anim::Model packed;
  if (const Status taken = read(SectionKind::model, file, model, packed); !taken) return taken.error();
  Status taken = read(SectionKind::surveyed_keys, file, model, packed.clips);
  if (!taken) return taken.error();
  anim::face_forward(packed);
  anim::place_model(packed, baked.prepared.placement.placement);
  if (baked.prepared.order) anim::reorder_bones(packed, *baked.prepared.order);
  packed.skeleton = baked.character.skeleton;  // which has the parts of the body that a person chose
  return packed;
}

std::span<const std::byte> Pack::surface(std::size_t file, std::size_t model) const {
  return section(SectionKind::surface, file, model);
}

Result<anim::ImportedFile> Pack::imported(std::size_t file) const {
  if (section(SectionKind::clips, file, 0).empty()) {
    return Error{path_ +
                 ": it has no keys of its model, which this needs: bake it with `throng bake --keep-keys`, or " +
                 "use the model that it was baked from"};
  }
  anim::ImportedFile imported = files_[file].header;
  for (std::size_t i = 0; i < files_[file].models; ++i) {
    anim::Model& model = imported.models.emplace_back();
    if (const Status taken = read(SectionKind::model, file, i, model); !taken) return taken.error();
    if (const Status taken = read(SectionKind::clips, file, i, model.clips); !taken) return taken.error();
  }
  return imported;
}

}  // namespace throng::pack
