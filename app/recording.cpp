#include "app/recording.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/preset.h"
#include "app/statistics.h"
#include "engine/anim/base/hash.h"

namespace throng::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int most_pixels = 16384;  // as --size

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json json_of(const Tuning& tuning) { return Json::parse(to_json(Preset{.tuning = tuning, .camera = {}})); }

std::uint64_t chained(std::uint64_t hash, std::string_view text) {
  for (const char letter : text) hash = anim::chain_hash(hash, static_cast<unsigned char>(letter));
  return anim::chain_hash(hash, text.size());
}

bool is_between(const Json& json, int least, int most) {
  return json.is_number_integer() && json.get<std::int64_t>() >= least && json.get<std::int64_t>() <= most;
}

bool read_roles(const Json& json, RoleClips& roles) {
  constexpr int most_clips = 65535;
  const auto is_clip = [](const Json& clip) { return is_between(clip, no_clip, most_clips); };
  if (!json.is_array() || json.size() != roles.size() || !std::ranges::all_of(json, is_clip)) return false;
  std::ranges::transform(json, roles.begin(), [](const Json& clip) { return clip.get<int>(); });
  return true;
}

bool read_character(const Json& json, RecordedCharacter& character) {
  if (!json.is_object() || !json.contains("file") || !json.contains("fingerprint") || !json.contains("roles")) {
    return false;
  }
  if (!json["file"].is_string() || !json["fingerprint"].is_string()) return false;
  character.file = json["file"].get<std::string>();
  character.fingerprint = json["fingerprint"].get<std::string>();
  return character.file.find('\0') == std::string::npos && read_roles(json["roles"], character.roles);
}

bool read_characters(const Json& json, std::vector<RecordedCharacter>& characters) {
  if (!json.is_array() || json.empty() || json.size() > most_models) return false;
  for (const Json& each : json) {
    if (!read_character(each, characters.emplace_back())) return false;
  }
  return true;
}

}  // namespace

RecordedCharacter recorded(const CharacterSource& source) {
  const anim::Character& character = *source.character;
  std::uint64_t hash = 0;
  for (const anim::Bone& bone : character.skeleton.bones) {
    hash = anim::chain_hash(chained(hash, bone.name), static_cast<std::uint64_t>(bone.parent));
  }
  for (const int bones : character.skeleton.level_bone_counts) {
    hash = anim::chain_hash(hash, static_cast<std::uint64_t>(bones));
  }
  for (const std::string& name : source.clip_names) hash = chained(hash, name);
  for (const anim::BakedClip& clip : character.clips) {
    hash = anim::chain_hash(hash, static_cast<std::uint64_t>(clip.duration));
  }
  return {.file = source.file, .fingerprint = hex_string(hash), .roles = source.roles.clips};
}

std::string changed_values(const Tuning& before, const Tuning& tuning) {
  const Json old_values = json_of(before);
  const Json values = json_of(tuning);
  Json changed = Json::object();
  for (const auto& [key, value] : values.items()) {
    if (old_values[key] != value) changed[key] = value;
  }
  return dumped(changed);
}

std::string header_text(const RecordingHeader& header) {
  Json json;
  json["width"] = header.width;
  json["height"] = header.height;
  for (const RecordedCharacter& character : header.characters) {
    json["characters"].push_back(
        {{"file", character.file}, {"fingerprint", character.fingerprint}, {"roles", character.roles}});
  }
  json["tuning"] = json_of(header.tuning);
  return dumped(json);
}

std::optional<std::string> read_header(std::string_view text, RecordingHeader& header) {
  const Json json = Json::parse(text, nullptr, false);
  const auto has = [&](const char* key) { return json.is_object() && json.contains(key); };
  if (!has("width") || !has("height") || !has("characters") || !has("tuning")) return "has a header that is none";
  if (!is_between(json["width"], 1, most_pixels) || !is_between(json["height"], 1, most_pixels)) {
    return "has a header with a picture of no size";
  }
  if (!read_characters(json["characters"], header.characters)) return "has a header with characters that are none";
  Preset preset;
  if (const Complaint complaint = from_json(dumped(json["tuning"]), preset))
    return "has a header in which " + *complaint;
  header.tuning = preset.tuning;
  header.width = json["width"].get<int>();
  header.height = json["height"].get<int>();
  return {};
}

}  // namespace throng::app
