#include "engine/anim/api/c/parts.h"

namespace throng::c {
namespace {

std::string& last_error() {
  static thread_local std::string error;
  return error;
}

throng_misuse_hook hook_of_c = nullptr;
void tell_c(const Misuse& misuse) {
  if (hook_of_c != nullptr) hook_of_c(misuse.call, misuse.reason);
}

/// Returns a file of C; null, with the error kept, if there is none.
throng_file* file_of(Result<LoadedFile> loaded) {
  if (loaded) return make<throng_file>(std::move(*loaded));
  fail(loaded.error().message);
  return nullptr;
}

}  // namespace

int fail(std::string why) {
  last_error() = std::move(why);
  return failed;
}

}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_version(void) { return version(); }
const char* throng_version_text(void) { return version_text(); }
const char* throng_last_error(void) { return last_error().c_str(); }

void throng_set_misuse_hook(throng_misuse_hook hook) {
  hook_of_c = hook;
  set_misuse_hook(hook == nullptr ? nullptr : tell_c);
}

throng_file* throng_load(const char* path, double metres_a_unit) {
  if (is_missing("throng_load", path)) return nullptr;
  return file_of(load(path, {.scale = metres_a_unit}));
}

throng_file* throng_load_bytes(const char* name, const void* bytes, size_t size, double metres_a_unit) {
  if (is_missing("throng_load_bytes", name, bytes)) return nullptr;
  const FileInMemory file{.name = name, .bytes = {static_cast<const std::byte*>(bytes), size}};
  return file_of(load({&file, 1}, {.scale = metres_a_unit}));
}

void throng_file_free(throng_file* file) { delete file; }

uint32_t throng_file_character_count(const throng_file* file) {
  return is_missing("throng_file_character_count", file) ? 0 : static_cast<uint32_t>(file->loaded.characters.size());
}

throng_character* throng_file_character(const throng_file* file, uint32_t index) {
  if (is_missing("throng_file_character", file)) return nullptr;
  if (index >= file->loaded.characters.size()) {
    fail("throng_file_character: the file has no character of this number");
    return nullptr;
  }
  const Character& own = file->loaded.characters[index];
  throng_character* const made = make<throng_character>(own);
  if (made == nullptr) return nullptr;
  for (std::uint32_t clip = 0; clip < own.clip_count(); ++clip) made->clip_names.emplace_back(own.clip({clip}).name);
  for (int bone = 0; bone < own.bone_count(); ++bone) made->bone_names.emplace_back(own.bone_name(bone));
  return made;
}

void throng_character_free(throng_character* character) { delete character; }

uint32_t throng_character_clip_count(const throng_character* character) {
  return is_missing("throng_character_clip_count", character) ? 0 : character->own.clip_count();
}

const char* throng_character_clip_name(const throng_character* character, uint32_t clip) {
  if (is_missing("throng_character_clip_name", character) || clip >= character->clip_names.size()) return nullptr;
  return character->clip_names[clip].c_str();
}

double throng_character_clip_seconds(const throng_character* character, uint32_t clip) {
  return is_missing("throng_character_clip_seconds", character) ? 0.0
                                                                : to_seconds(character->own.clip({clip}).duration);
}

uint32_t throng_character_find_clip(const throng_character* character, const char* name) {
  if (is_missing("throng_character_find_clip", character) || is_missing("throng_character_find_clip", name)) {
    return THRONG_NONE;
  }
  return character->own.find_clip(name).number;
}

uint32_t throng_character_find_role(const throng_character* character, const char* role) {
  if (is_missing("throng_character_find_role", character) || is_missing("throng_character_find_role", role)) {
    return THRONG_NONE;
  }
  return character->own.find_role(role).number;
}

uint32_t throng_character_bone_count(const throng_character* character) {
  if (is_missing("throng_character_bone_count", character)) return 0;
  return static_cast<uint32_t>(character->own.bone_count());
}

const char* throng_character_bone_name(const throng_character* character, uint32_t bone) {
  if (is_missing("throng_character_bone_name", character) || bone >= character->bone_names.size()) return nullptr;
  return character->bone_names[bone].c_str();
}

uint32_t throng_character_palette_entries(const throng_character* character) {
  return is_missing("throng_character_palette_entries", character) ? 0 : character->own.palette_entries();
}

const char* throng_character_key_name(const throng_character* character, uint32_t name) {
  if (is_missing("throng_character_key_name", character)) return nullptr;
  const std::span<const std::string> names = character->own.data_key_names();
  return name < names.size() ? names[name].c_str() : nullptr;
}
