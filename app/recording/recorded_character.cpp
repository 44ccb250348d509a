#include "app/recording/recorded_character.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "app/character/body_parts.h"
#include "app/character/bone_lod.h"
#include "app/character/rig_table.h"
#include "app/figures/statistics.h"
#include "app/files/byte_hash.h"
#include "app/settings/settings.h"
#include "engine/anim/base/hash.h"
#include "engine/anim/base/plain_text.h"
#include "engine/anim/import/json/json_object.h"

namespace throng::app {
namespace {

std::uint64_t chained(std::uint64_t hash, std::string_view text) {
  ByteHash bytes;
  bytes.add(text);
  return anim::chain_hash(hash, bytes.value());
}

// A sum of hashes, so that the order does not matter.
std::uint64_t hash_of_bones(const anim::Skeleton& skeleton) {
  const std::vector<std::string> keys = bone_keys(skeleton);
  std::uint64_t sum = 0;
  for (std::size_t bone = 0; bone < keys.size(); ++bone) {
    const int parent = skeleton.bones[bone].parent;
    sum += chained(chained(0, keys[bone]), parent < 0 ? "" : keys[static_cast<std::size_t>(parent)]);
  }
  return sum;
}

std::string fingerprint(const CharacterSource& source) {
  std::uint64_t hash = hash_of_bones(source.character->skeleton);
  for (const std::string& name : source.clip_names) hash = chained(hash, name);
  for (const anim::BakedClip& clip : source.character->clips) {
    hash = anim::chain_hash(hash, static_cast<std::uint64_t>(clip.duration.count()));
  }
  return hex_string(hash);
}

/// Returns the name of a file as a text, or as a list of its bytes where they are no UTF-8, which JSON demands.
Json name_json(const std::string& file) {
  if (anim::is_utf8(file)) return file;
  Json bytes = Json::array();
  for (const char byte : file) bytes.push_back(static_cast<int>(static_cast<unsigned char>(byte)));
  return bytes;
}

bool read_name(const Json& json, std::string& file) {
  constexpr int most_byte = 255;
  if (json.is<std::string>()) {
    file = json.get<std::string>();
  } else if (json.are_whole(1, most_byte)) {
    file.clear();
    for (const Json& byte : json.elements()) file += static_cast<char>(byte.get<int>());
  } else {
    return false;
  }
  return file.find('\0') == std::string::npos;
}

void read_placement(const JsonObject& character, anim::PlacementChoice& placement) {
  const auto read = recorded_placement(character["placement"]);
  if (!read) return character.wrong("placement", "a scale, an axis and a rule, as numbers");
  placement = *read;
}

void read_roles(const JsonObject& character, RoleClips& roles) {
  constexpr int most_clips = 65535;
  std::vector<int> clips;
  character.wholes("roles", clips, no_clip, most_clips);
  constexpr std::size_t fewest = 9;  // of an earlier version, which knew fewer roles
  if (clips.size() < fewest || clips.size() > roles.size()) {
    return character.wrong("roles", std::to_string(roles.size()) + " clips");
  }
  std::ranges::copy(clips, roles.begin());
}

RecordedCharacter read_character(const JsonObject& json) {
  RecordedCharacter character;
  json.need({"file", "fingerprint", "roles", "bones", "level_counts"});
  if (!read_name(json["file"], character.file)) json.wrong("file", "the name of a file");
  json.text("fingerprint", character.fingerprint);
  read_roles(json, character.roles);
  json.texts("bones", character.bones);
  json.wholes("level_counts", character.level_counts, 1, anim::max_bones);
  if (json.has("placement")) read_placement(json, character.placement);
  json.number("share", character.share);
  if (!is_share(character.share)) json.wrong("share", "a share of the crowd");
  for (const Json& file : json.elements("clip_files")) {
    if (!read_name(file, character.clip_files.emplace_back())) json.wrong("clip_files", "names of files");
  }
  if (json.has("rig") && !(character.rig = recorded_rig(json["rig"]))) json.wrong("rig", "parts of the body and bones");
  if (json.has("rules")) character.rules = recorded_rules(json["rules"]);
  return character;
}

anim::Status take_bone_lod(const RecordedCharacter& recorded, CharacterSource& source) {
  auto bones = bones_named(recorded.bones, source.model.skeleton);
  if (!bones) return bones.error();
  const BoneLodChoice choice{.bones = std::move(*bones), .level_counts = recorded.level_counts};
  if (anim::Status checked = check_bone_lod(source.model.skeleton, choice); !checked) return checked;
  take_order(source, choice);
  return anim::Done{};
}

}  // namespace

RecordedCharacter recorded(const CharacterSource& character) {
  const anim::Skeleton& skeleton = character.character->skeleton;
  return {.file = character.file,
          .fingerprint = fingerprint(character),
          .roles = character.roles.clips,
          .bones = bone_keys(skeleton),
          .level_counts = skeleton.level_bone_counts,
          .placement = character.placement.choice,
          .share = character.roles.share,
          .clip_files = character.clip_files,
          .rig = character.rig,
          .rules = character.rules};
}

std::vector<RecordedCharacter> recorded(std::span<const CharacterSource> characters) {
  std::vector<RecordedCharacter> all;
  for (const CharacterSource& character : characters) all.push_back(recorded(character));
  return all;
}

Json recorded_rules_json(const std::string& rules) {
  auto json = parse_json(rules);
  return json ? std::move(*json) : Json(nullptr);
}

std::string recorded_rules(const Json& json) { return json.is_null() ? std::string() : json.dump(); }

Json placement_json(const anim::PlacementChoice& placement) {
  return Json::array(
      {placement.scale.value_or(0.0), static_cast<int>(placement.up), static_cast<int>(placement.ground)});
}

std::optional<anim::PlacementChoice> recorded_placement(const Json& json) {
  constexpr int last_axis = static_cast<int>(anim::UpAxis::minus_z),
                last_rule = static_cast<int>(anim::GroundRule::feet);
  const std::span<const Json> values = json.elements();
  const bool can_be = values.size() == 3 && values[0].is<double>() && values[0].get<double>() >= 0.0 &&
                      values[1].is_whole(0, last_axis) && values[2].is_whole(0, last_rule);
  if (!can_be) return {};
  anim::PlacementChoice placement;
  if (const auto scale = values[0].get<double>(); scale > 0.0) placement.scale = scale;
  placement.up = static_cast<anim::UpAxis>(values[1].get<int>());
  placement.ground = static_cast<anim::GroundRule>(values[2].get<int>());
  return placement;
}

std::optional<std::vector<RigChoice>> recorded_rig(const Json& json) {
  auto choices = rig_choices_in(json, JsonFile({}));
  return choices ? std::optional(std::move(*choices)) : std::nullopt;
}

bool has_clips(const CharacterSource& character, const RoleClips& roles) {
  const auto clips = static_cast<int>(character.clip_names.size());
  return std::ranges::all_of(roles, [&](int clip) { return clip >= no_clip && clip < clips; });
}

anim::Status become_recorded(const RecordedCharacter& as_recorded, CharacterSource& character) {
  RecordedCharacter here = recorded(character);
  if (here.fingerprint != as_recorded.fingerprint) {
    return anim::Error{character.name + " is not the character that was recorded: its bones or clips differ"};
  }
  if (here.bones != as_recorded.bones || here.level_counts != as_recorded.level_counts) {
    if (const anim::Status taken = take_bone_lod(as_recorded, character); !taken) {
      return anim::Error{"the order of bones kept for " + character.name + ": " + taken.error().message};
    }
  }
  if (as_recorded.rig && *as_recorded.rig != character.rig) {
    if (const anim::Status taken = take_rig(character, *as_recorded.rig); !taken) {
      return anim::Error{"the parts of the body kept for " + character.name + ": " + taken.error().message};
    }
  }
  if (!has_clips(character, as_recorded.roles)) return anim::Error{"plays a clip that " + character.name + " has not"};
  if (as_recorded.rules) character.rules = as_recorded.rules;
  assign_roles(character, as_recorded.roles);
  character.roles.share = as_recorded.share;
  return anim::Done{};
}

std::vector<CastEntry> entries_of(std::span<const RecordedCharacter> characters) {
  std::vector<CastEntry> entries;
  for (const RecordedCharacter& character : characters) {
    entries.push_back({.file = character.file,
                       .share = character.share,
                       .clip_files = character.clip_files,
                       .placement = character.placement});
  }
  return entries;
}

Json to_json(std::span<const RecordedCharacter> characters) {
  Json json = Json::array();
  for (const RecordedCharacter& character : characters) {
    Json clip_files = Json::array();
    for (const std::string& file : character.clip_files) clip_files.push_back(name_json(file));
    Json each = {{"file", name_json(character.file)},
                 {"fingerprint", character.fingerprint},
                 {"roles", character.roles},
                 {"bones", character.bones},
                 {"level_counts", character.level_counts},
                 {"placement", placement_json(character.placement)},
                 {"share", character.share},
                 {"clip_files", std::move(clip_files)}};
    if (character.rig) each["rig"] = rig_json(*character.rig);
    if (character.rules) each["rules"] = recorded_rules_json(*character.rules);
    json.push_back(std::move(each));
  }
  return json;
}

std::vector<RecordedCharacter> read_characters(std::span<const Json> json, std::optional<std::string>& complaint) {
  std::vector<RecordedCharacter> characters;
  for (const Json& each : json) {
    const std::string name = "character " + std::to_string(characters.size());
    characters.push_back(read_character(JsonObject(
        name, each,
        {"file", "fingerprint", "roles", "bones", "level_counts", "placement", "share", "clip_files", "rig", "rules"},
        complaint)));
    if (complaint) break;
  }
  if (!complaint && (json.empty() || json.size() > most_models)) {
    complaint = "\"characters\" must be 1 to " + std::to_string(most_models) + " characters";
  }
  return characters;
}

}  // namespace throng::app
