#include "engine/anim/api/c/parts.h"

using namespace throng::c;  // NOLINT: functions of C have no namespace

void throng_character_free(throng_character* character) { delete character; }

uint32_t throng_character_clip_count(const throng_character* character) {
  return is_missing("throng_character_clip_count", character) ? 0 : character->own.clip_count();
}

int throng_character_has_clip(const throng_character* character, uint32_t clip) {
  return !is_missing("throng_character_has_clip", character) && character->own.has({clip}) ? 1 : 0;
}

const char* throng_character_clip_name(const throng_character* character, uint32_t clip) {
  if (is_missing("throng_character_clip_name", character)) return nullptr;
  return text_of(character->own.clip({clip}).name);
}

double throng_character_clip_seconds(const throng_character* character, uint32_t clip) {
  return is_missing("throng_character_clip_seconds", character) ? 0.0
                                                                : to_seconds(character->own.clip({clip}).duration);
}

int throng_character_clip_loops(const throng_character* character, uint32_t clip) {
  return !is_missing("throng_character_clip_loops", character) && character->own.clip({clip}).loops ? 1 : 0;
}

double throng_character_clip_ground_speed(const throng_character* character, uint32_t clip) {
  return is_missing("throng_character_clip_ground_speed", character) ? 0.0 : character->own.clip({clip}).ground_speed;
}

uint32_t throng_character_find_clip(const throng_character* character, const char* name) {
  if (is_missing("throng_character_find_clip", character, name)) return THRONG_NONE;
  return character->own.find_clip(name).number;
}

uint32_t throng_character_find_role(const throng_character* character, const char* role) {
  const Call call("throng_character_find_role");
  if (call.is_missing(character, role)) return THRONG_NONE;
  const uint32_t clip = character->own.find_role(role).number;
  return call.went_well() ? clip : THRONG_NONE;
}

throng_character* throng_character_with_clips(const throng_character* character, const throng_character* more) {
  if (is_missing("throng_character_with_clips", character, more)) return nullptr;
  return make_of<throng_character>(character->own.with_clips(more->own));
}

throng_character* throng_character_without(const throng_character* character, uint32_t clip) {
  if (is_missing("throng_character_without", character)) return nullptr;
  return make_of<throng_character>(character->own.without({clip}));
}

const char* throng_character_key_name(const throng_character* character, uint32_t name) {
  if (is_missing("throng_character_key_name", character)) return nullptr;
  return text_at(character->own.data_key_names(), name);
}

const char* throng_character_curve_name(const throng_character* character, uint32_t name) {
  if (is_missing("throng_character_curve_name", character)) return nullptr;
  return text_at(character->own.curve_names(), name);
}

const char* throng_character_morph_name(const throng_character* character, uint32_t name) {
  if (is_missing("throng_character_morph_name", character)) return nullptr;
  return text_at(character->own.morph_names(), name);
}

uint32_t throng_character_bone_count(const throng_character* character) {
  if (is_missing("throng_character_bone_count", character)) return 0;
  return static_cast<uint32_t>(character->own.bone_count());
}

const char* throng_character_bone_name(const throng_character* character, uint32_t bone) {
  if (is_missing("throng_character_bone_name", character)) return nullptr;
  return text_of(character->own.bone_name(static_cast<int>(bone)));
}

uint32_t throng_character_bone_parent(const throng_character* character, uint32_t bone) {
  if (is_missing("throng_character_bone_parent", character)) return THRONG_NONE;
  return static_cast<uint32_t>(character->own.bone_parent(static_cast<int>(bone)));  // -1 becomes THRONG_NONE
}

uint32_t throng_character_find_bone(const throng_character* character, const char* name) {
  if (is_missing("throng_character_find_bone", character, name)) return THRONG_NONE;
  return static_cast<uint32_t>(character->own.find_bone(name).value_or(-1));
}

double throng_character_height(const throng_character* character) {
  return is_missing("throng_character_height", character) ? 0.0 : character->own.height();
}

int throng_character_bounds(const throng_character* character, throng_bounding_sphere* sphere) {
  if (is_missing("throng_character_bounds", character, sphere)) return failed;
  *sphere = std::bit_cast<throng_bounding_sphere>(character->own.bounds());
  return done;
}

int throng_character_clip_bounds(const throng_character* character, uint32_t clip, throng_bounding_box* box) {
  const Call call("throng_character_clip_bounds");
  if (call.is_missing(character, box)) return failed;
  if (!character->own.has({clip}))
    return fail("throng_character_clip_bounds: the character has no clip of this number");
  *box = std::bit_cast<throng_bounding_box>(character->own.bounds(ClipId{clip}));
  return call.outcome();
}

const char* throng_character_missing_rig(const throng_character* character, uint32_t index) {
  if (is_missing("throng_character_missing_rig", character)) return nullptr;
  return text_at(character->own.missing_rigs(), index);
}

uint32_t throng_character_level_count(const throng_character* character) {
  if (is_missing("throng_character_level_count", character)) return 0;
  return static_cast<uint32_t>(character->own.level_count());
}

uint32_t throng_character_palette_entries(const throng_character* character, uint32_t level) {
  if (is_missing("throng_character_palette_entries", character)) return 0;
  return character->own.palette_entries(static_cast<int>(level));
}

uint32_t throng_character_entries_at_level(const throng_character* character, uint32_t level, uint16_t* entries,
                                           uint32_t most) {
  const Call call("throng_character_entries_at_level");
  if (call.is_missing(character) || call.lacks(entries, most)) return 0;
  return list(character->own.entries_at_level(static_cast<int>(level)), entries, most);
}

uint32_t throng_character_packing_frames(const throng_character* character, float* frames, uint32_t most) {
  const Call call("throng_character_packing_frames");
  if (call.is_missing(character) || call.lacks(frames, most)) return 0;
  using Frame = std::array<float, 4>;
  return list(character->own.packing_frames(), reinterpret_cast<Frame*>(frames), most);
}
