#include "engine/anim/api/c/parts.h"

namespace throng::c {

std::optional<LoadOptions> load_options_of(const Call& call, const throng_load_options* given,
                                           std::vector<BoneRole>& rig) {
  const auto read = call.read("throng_load_options", given);
  if (!read || call.lacks(read->rig, read->rig_count)) return std::nullopt;
  const throng_load_options& options = *read;
  LoadOptions own;
  own.scale = options.metres_a_unit;
  own.strict = options.strict != 0;
  own.keep_meshes = options.keep_meshes != 0;
  own.walk_in_place = options.walk_in_place != 0;
  own.memory_limit = options.memory_limit;
  own.copy_pack = options.copy_pack != 0;
  own.keep_keys = options.keep_keys != 0;
  own.close_loops = options.close_loops != 0;
  for (const throng_bone_role& one : std::span(options.rig, options.rig_count))
    rig.push_back({.role = view_of(one.role), .bone = view_of(one.bone)});
  own.rig = rig;
  return own;
}

namespace {

throng_file* load_bytes(std::span<const FileInMemory> files, const LoadOptions& options) {
  return make_of<throng_file>(load(files, options));
}

LoadOptions scaled(double metres_a_unit) {
  LoadOptions options;
  options.scale = metres_a_unit;
  return options;
}

}  // namespace

template <>
throng_load_options default_of() {
  const LoadOptions own;
  throng_load_options options{};
  options.strict = own.strict ? 1 : 0;
  options.keep_meshes = own.keep_meshes ? 1 : 0;
  options.walk_in_place = own.walk_in_place ? 1 : 0;
  options.copy_pack = own.copy_pack ? 1 : 0;
  options.keep_keys = own.keep_keys ? 1 : 0;
  options.close_loops = own.close_loops ? 1 : 0;
  options.metres_a_unit = own.scale;
  options.memory_limit = own.memory_limit;
  return options;
}

}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_load_options_fill(throng_load_options* into, size_t size) {
  return fill("throng_load_options_fill", into, size);
}

throng_file* throng_load(const char* path, double metres_a_unit) {
  if (is_missing("throng_load", path)) return nullptr;
  return make_of<throng_file>(load(path, scaled(metres_a_unit)));
}

throng_file* throng_load_with(const char* path, const throng_load_options* options) {
  const Call call("throng_load_with");
  if (call.is_missing(path)) return nullptr;
  std::vector<BoneRole> rig;
  const auto own = load_options_of(call, options, rig);
  return own ? make_of<throng_file>(load(path, *own)) : nullptr;
}

throng_file* throng_load_bytes(const char* name, const void* bytes, size_t size, double metres_a_unit) {
  if (is_missing("throng_load_bytes", name, bytes)) return nullptr;
  const FileInMemory file{.name = name, .bytes = {static_cast<const std::byte*>(bytes), size}};
  return load_bytes({&file, 1}, scaled(metres_a_unit));
}

throng_file* throng_load_bytes_with(const throng_bytes* files, uint32_t count, const throng_load_options* options) {
  const Call call("throng_load_bytes_with");
  if (call.is_missing(files)) return nullptr;
  std::vector<BoneRole> rig;
  const auto read = load_options_of(call, options, rig);
  if (!read) return nullptr;
  std::vector<FileInMemory> own;
  for (const throng_bytes& file : std::span(files, count)) {
    if (call.is_missing(file.name, file.bytes)) return nullptr;
    own.push_back({.name = file.name, .bytes = {static_cast<const std::byte*>(file.bytes), file.count}});
  }
  return load_bytes(own, *read);
}

void throng_file_free(throng_file* file) { delete file; }

uint32_t throng_file_character_count(const throng_file* file) {
  return is_missing("throng_file_character_count", file) ? 0 : static_cast<uint32_t>(file->loaded.characters.size());
}

throng_character* throng_file_character(const throng_file* file, uint32_t index) {
  if (is_missing("throng_file_character", file)) return nullptr;
  if (index < file->loaded.characters.size()) return make<throng_character>(file->loaded.characters[index]);
  fail("throng_file_character: the file has no character of this number");
  return nullptr;
}

const char* throng_file_note(const throng_file* file, uint32_t index) {
  return is_missing("throng_file_note", file) ? nullptr : text_at(file->loaded.notes, index);
}

int throng_save(const char* path, const throng_character* const* characters, uint32_t count) {
  const Call call("throng_save");
  if (call.is_missing(path, characters)) return failed;
  std::vector<Character> own;
  for (const throng_character* const character : std::span(characters, count)) {
    if (call.is_missing(character)) return failed;
    own.push_back(character->own);
  }
  return outcome(save(path, own));
}
