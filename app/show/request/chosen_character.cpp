#include "app/show/request/chosen_character.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "app/character/body_parts.h"
#include "app/character/bone_lod.h"
#include "app/character/rig_table.h"
#include "app/character/role_table.h"
#include "app/files/byte_hash.h"
#include "app/files/json_file.h"
#include "app/settings/choices.h"
#include "app/settings/option_values.h"
#include "engine/base/hash.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

std::uint64_t chained(std::uint64_t hash, std::string_view text) {
  ByteHash bytes;
  bytes.add(text);
  return chain_hash(hash, bytes.value());
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
    hash = chain_hash(hash, static_cast<std::uint64_t>(clip.duration.count()));
  }
  return hex_string(hash);
}

void read_word(const JsonObject& json, const std::string& key, const ValueReader& reader) {
  if (!json.has(key)) return;
  std::string word;
  json.text(key, word);
  if (const Complaint complaint = reader(word)) json.complain("\"" + key + "\" " + *complaint);
}

ChosenCharacter read_character(const std::string& name, const Json& json, std::optional<std::string>& complaint) {
  ChosenCharacter character;
  const JsonObject object(
      name, json,
      {"model", "fingerprint", "share", "clips", "clips_from", "rig", "rules", "placement", "level_counts", "bones"},
      complaint);
  if (object.has("model") && !read_name(object["model"], character.file)) object.wrong("model", "the name of a file");
  object.text("fingerprint", character.fingerprint);
  object.number("share", character.share);
  if (!is_share(character.share)) object.wrong("share", "above 0 and at most " + shortest_text(most_share));
  for (const Json& file : object.elements("clips_from")) {
    if (!read_name(file, character.clip_files.emplace_back())) object.wrong("clips_from", "names of files");
  }
  object.texts("bones", character.bones);
  object.wholes("level_counts", character.level_counts, 1, anim::max_bones);
  if (object.has("placement")) read_placement(name + ": placement", json["placement"], complaint, character.placement);
  if (object.has("rules")) character.rules = rules_in(json["rules"]);
  if (object.has("clips") && !complaint) complaint = read_role_choices(json["clips"], character.clips);
  if (object.has("rig") && !complaint) complaint = read_rig_choices(json["rig"], character.rig);
  return character;
}

Status take_bone_lod(const ChosenCharacter& wanted, CharacterSource& source) {
  auto bones = bones_named(wanted.bones, source.model.skeleton);
  if (!bones) return bones.error();
  const BoneLodChoice choice{.bones = std::move(*bones), .level_counts = wanted.level_counts};
  if (Status checked = check_bone_lod(source.model.skeleton, choice); !checked) return checked;
  take_order(source, choice);
  source.order_is_chosen = true;
  return Done{};
}

Error about(const std::string& what, const CharacterSource& character, const Status& wrong) {
  return {"the " + what + " kept for " + character.name + ": " + wrong.error().message};
}

}  // namespace

ChosenCharacter exactly(const CharacterSource& character) {
  ChosenCharacter all = chosen(character);
  all.fingerprint = fingerprint(character);
  all.rules = character.rules;
  return all;
}

std::vector<ChosenCharacter> exactly(std::span<const CharacterSource> characters) {
  std::vector<ChosenCharacter> all;
  for (const CharacterSource& character : characters) all.push_back(exactly(character));
  return all;
}

ChosenCharacter chosen(const CharacterSource& character) {
  const anim::Skeleton& skeleton = character.character->skeleton;
  return {.file = character.file,
          .share = character.roles.share,
          .clip_files = character.clip_files,
          .placement = character.placement.choice,
          .clips = all_choices(character.roles.clips, character.clip_names),
          .bones = bone_keys(skeleton),
          .level_counts = skeleton.level_bone_counts,
          .rig = character.rig,
          .rules = character.rules_are_chosen ? character.rules : std::nullopt};
}

bool has_clips(const CharacterSource& character, const RoleClips& roles) {
  const auto clips = static_cast<int>(character.clip_names.size());
  return std::ranges::all_of(roles, [&](int clip) { return clip >= no_clip && clip < clips; });
}

std::vector<CastEntry> entries_of(std::span<const ChosenCharacter> characters) {
  std::vector<CastEntry> entries;
  for (const ChosenCharacter& character : characters) {
    if (character.file.empty()) continue;
    entries.push_back({.file = character.file,
                       .share = character.share,
                       .clip_files = character.clip_files,
                       .placement = character.placement});
  }
  return entries;
}

Status become(const ChosenCharacter& wanted, CharacterSource& character) {
  if (!wanted.fingerprint.empty() && wanted.fingerprint != fingerprint(character)) {
    return Error{character.name + " is not the character that was recorded: its bones or clips differ"};
  }
  const anim::Skeleton& skeleton = character.character->skeleton;
  const bool keeps_order = wanted.bones.empty() ||
                           (bone_keys(skeleton) == wanted.bones && skeleton.level_bone_counts == wanted.level_counts);
  if (!keeps_order) {
    const Status taken = take_bone_lod(wanted, character);
    if (!taken) return about("order of bones", character, taken);
  }
  if (wanted.rig != character.rig) {
    const Status taken = take_rig(character, wanted.rig);
    if (!taken) return about("parts of the body", character, taken);
  }
  RoleClips roles = character.roles.clips;
  const Status clips = choose_clips(wanted.clips, character.clip_names, roles);
  if (!clips) return Error{character.name + ": " + clips.error().message};
  character.rules_are_chosen = wanted.rules.has_value();
  if (wanted.rules) character.rules = wanted.rules;
  assign_roles(character, roles);
  character.roles.share = wanted.share;
  return Done{};
}

Json to_json(const ChosenCharacter& character) {
  Json clip_files = Json::array();
  for (const std::string& file : character.clip_files) clip_files.push_back(name_json(file));
  Json json = {{"share", character.share},
               {"clips", clips_json(character.clips)},
               {"rig", rig_json(character.rig)},
               {"placement", to_json(character.placement)},
               {"level_counts", character.level_counts},
               {"bones", character.bones},
               {"clips_from", std::move(clip_files)}};
  if (!character.file.empty()) json["model"] = name_json(character.file);
  if (!character.fingerprint.empty()) json["fingerprint"] = character.fingerprint;
  if (character.rules) json["rules"] = rules_json(*character.rules);
  return json;
}

Json to_json(std::span<const ChosenCharacter> characters) {
  Json json = Json::array();
  for (const ChosenCharacter& character : characters) json.push_back(to_json(character));
  return json;
}

std::vector<ChosenCharacter> read_characters(const Json& json, std::optional<std::string>& complaint) {
  std::vector<ChosenCharacter> characters;
  const std::size_t count = json.elements().size();
  if (!complaint && (count == 0 || count > most_models)) {
    complaint = "\"characters\" must be 1 to " + std::to_string(most_models) + " characters";
  }
  for (std::size_t i = 0; i < count && !complaint; ++i) {
    characters.push_back(read_character("character " + std::to_string(i), json.elements()[i], complaint));
  }
  const auto is_built_in = [](const ChosenCharacter& character) { return character.file.empty(); };
  if (!complaint && count > 1 && std::ranges::any_of(characters, is_built_in)) {
    complaint = "the built-in character stands alone; give each of several characters a \"model\"";
  }
  return characters;
}

Json to_json(const anim::PlacementChoice& placement) {
  Json json = {{"up", up_axis_words.at(static_cast<std::size_t>(placement.up))}};
  if (placement.ground != anim::PlacementChoice().ground) {
    json["ground"] = ground_words.at(static_cast<std::size_t>(placement.ground));
  }
  if (placement.scale) json["scale"] = *placement.scale;
  return json;
}

void read_placement(const std::string& name, const Json& json, std::optional<std::string>& complaint,
                    anim::PlacementChoice& placement) {
  const JsonObject object(name, json, {"scale", "up", "ground"}, complaint);
  if (object.has("scale")) object.number("scale", placement.scale.emplace(1.0), least_scale, most_scale);
  read_word(object, "up", up_axis(placement.up));
  read_word(object, "ground", ground_rule(placement.ground));
}

Json rules_json(const std::string& rules) {
  auto json = parse_json(rules);
  return json ? std::move(*json) : Json(nullptr);
}

std::string rules_in(const Json& json) { return json.is_null() ? std::string() : json.dump(); }

}  // namespace throng::app
