#include "app/recording/crowd_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/character/body_parts.h"
#include "app/character/bone_lod.h"
#include "app/character/rig_table.h"
#include "app/character/skin_choice.h"
#include "app/files/json_file.h"
#include "app/recording/recorded_character.h"
#include "app/settings/choices.h"
#include "app/settings/placement_options.h"
#include "engine/anim/import/json/json_object.h"
#include "engine/files/output_file.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;
constexpr int crowd_file_version = 1;

/// Returns the absolute path of a folder, without links where it can be told.
fs::path whole_path(const fs::path& path) {
  std::error_code failed;
  const fs::path whole = fs::weakly_canonical(path, failed);
  return failed ? fs::absolute(path, failed) : whole;
}

std::string relative_to(const fs::path& folder, const std::string& file) {
  if (file.empty()) return file;
  const CharacterFile named = character_file(file);
  const fs::path relative = whole_path(named.path).lexically_relative(whole_path(folder));
  return with_skin(relative.empty() ? whole_path(named.path).string() : relative.generic_string(), named.skin);
}

std::string found_from(const fs::path& folder, const std::string& file) {
  if (file.empty()) return file;
  const CharacterFile named = character_file(file);
  return with_skin((folder / named.path).lexically_normal().string(), named.skin);
}

Json placement_in_words(const anim::PlacementChoice& placement) {
  Json json = {{"up", up_axis_words.at(static_cast<std::size_t>(placement.up))}};
  if (placement.ground != anim::PlacementChoice().ground) {
    json["ground"] = ground_words.at(static_cast<std::size_t>(placement.ground));
  }
  if (placement.scale) json["scale"] = *placement.scale;
  return json;
}

void read_word(const JsonObject& json, const std::string& key, const ValueReader& reader) {
  if (!json.has(key)) return;
  std::string word;
  json.text(key, word);
  if (const Complaint complaint = reader(word)) json.complain("\"" + key + "\" " + *complaint);
}

void read_placement(const std::string& name, const Json& json, std::optional<std::string>& complaint,
                    anim::PlacementChoice& placement) {
  const JsonObject object(name, json, {"scale", "up", "ground"}, complaint);
  constexpr double least_scale = 1e-6, most_scale = 1e6;
  if (object.has("scale")) object.number("scale", placement.scale.emplace(1.0), least_scale, most_scale);
  read_word(object, "up", up_axis(placement.up));
  read_word(object, "ground", ground_rule(placement.ground));
}

Json character_json(const fs::path& folder, const CrowdCharacter& character) {
  Json json = {{"share", character.share},
               {"clips", clips_json(character.clips)},
               {"rig", rig_json(character.rig)},
               {"placement", placement_in_words(character.placement)},
               {"level_counts", character.level_counts},
               {"bones", character.bones}};
  if (character.rules) json["rules"] = recorded_rules_json(*character.rules);
  if (!character.file.empty()) json["model"] = relative_to(folder, character.file);
  Json clip_files = Json::array();
  for (const std::string& file : character.clip_files) clip_files.push_back(relative_to(folder, file));
  json["clips_from"] = std::move(clip_files);
  return json;
}

/// Takes what `parse(json, file)` makes of a member. Its error is a whole sentence, which ends the reading.
template <typename Choice, typename Parse>
anim::Status read_choices(const Json& json, const char* key, const JsonFile& file, const Parse& parse,
                          std::vector<Choice>& choices) {
  if (!json.contains(key)) return anim::Done{};
  auto read = parse(json[key], file);
  if (!read) return read.error();
  choices = std::move(*read);
  return anim::Done{};
}

anim::Result<CrowdCharacter> read_crowd_character(const std::string& name, const Json& json, const fs::path& path) {
  CrowdCharacter character;
  std::optional<std::string> complaint;
  const JsonFile file(path);
  const JsonObject object(
      name, json, {"model", "share", "clips", "clips_from", "rig", "rules", "placement", "level_counts", "bones"},
      complaint);
  object.text("model", character.file);
  object.number("share", character.share, least_share, most_share);
  object.texts("clips_from", character.clip_files);
  object.texts("bones", character.bones);
  object.wholes("level_counts", character.level_counts, 1, anim::max_bones);
  if (object.has("placement")) read_placement(name + ": placement", json["placement"], complaint, character.placement);
  if (object.has("rules")) character.rules = recorded_rules(json["rules"]);
  if (complaint) return file.wrong(*complaint);
  if (const auto read = read_choices(json, "clips", file, role_choices_in, character.clips); !read) return read.error();
  if (const auto read = read_choices(json, "rig", file, rig_choices_in, character.rig); !read) return read.error();
  character.file = found_from(path.parent_path(), character.file);
  for (std::string& other : character.clip_files) other = found_from(path.parent_path(), other);
  return character;
}

// The keys are digits: "3" is the third bookmark.
Json bookmarks_json(const CameraBookmarks& bookmarks) {
  Json json = Json::object();
  for (std::size_t i = 0; i < bookmarks.size(); ++i) {
    if (bookmarks.at(i)) json[std::to_string(i + 1)] = camera_text(*bookmarks.at(i));
  }
  return json;
}

void read_bookmarks(const Json& json, std::optional<std::string>& complaint, CameraBookmarks& bookmarks) {
  const JsonObject object("bookmarks", json, {"1", "2", "3", "4", "5", "6", "7", "8", "9"}, complaint);
  for (std::size_t i = 0; i < bookmarks.size(); ++i) {
    const std::string digit = std::to_string(i + 1);
    if (!object.has(digit)) continue;
    if (const Complaint wrong = read_camera_place(digit, object[digit], bookmarks.at(i))) object.complain(*wrong);
  }
}

}  // namespace

bool is_crowd_file(const fs::path& file) { return file.extension() == crowd_file_ending; }

std::vector<std::string> crowd_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (is_crowd_file(entry->path()) && entry->is_regular_file(error)) names.push_back(entry->path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

CrowdSetup crowd_setup(std::span<const CharacterSource> people, const Preset& preset) {
  CrowdSetup setup{.characters = {}, .preset = preset};
  for (const CharacterSource& person : people) {
    setup.characters.push_back({.file = person.file,
                                .share = person.roles.share,
                                .clip_files = person.clip_files,
                                .placement = person.placement.choice,
                                .clips = all_choices(person.roles.clips, person.clip_names),
                                .bones = bone_keys(person.character->skeleton),
                                .level_counts = person.character->skeleton.level_bone_counts,
                                .rig = person.rig,
                                .rules = person.rules_are_chosen ? person.rules : std::nullopt});
  }
  return setup;
}

anim::Status write_crowd_file(const fs::path& file, const CrowdSetup& setup) {
  Json characters = Json::array();
  for (const CrowdCharacter& character : setup.characters) {
    characters.push_back(character_json(file.parent_path(), character));
  }
  Json json = {
      {"version", crowd_file_version}, {"characters", std::move(characters)}, {"values", to_json(setup.preset)}};
  if (setup.pair != TuningPair()) json["compare"] = to_json(setup.pair);
  if (setup.bookmarks != CameraBookmarks()) json["bookmarks"] = bookmarks_json(setup.bookmarks);
  return write_whole_file(file, json.dump(2) + "\n");
}

anim::Result<CrowdSetup> read_crowd_file(const fs::path& path) {
  const JsonFile file(path);
  const auto json = file.read();
  if (!json) return json.error();
  std::optional<std::string> complaint;
  const JsonObject object("", *json, {"version", "characters", "values", "compare", "bookmarks"}, complaint);
  object.version(crowd_file_version);
  object.need({"characters"});
  const std::span<const Json> characters = object.elements("characters");
  if (!complaint && (characters.empty() || characters.size() > most_models)) {
    complaint = "\"characters\" must be 1 to " + std::to_string(most_models) + " characters";
  }
  CrowdSetup setup;
  if (!complaint && json->contains("values")) complaint = from_json((*json)["values"], setup.preset);
  if (!complaint && json->contains("compare")) complaint = from_json((*json)["compare"], setup.pair);
  if (json->contains("bookmarks")) read_bookmarks((*json)["bookmarks"], complaint, setup.bookmarks);
  if (complaint) return file.wrong(*complaint);
  for (const Json& each : characters) {
    auto character = read_crowd_character("character " + std::to_string(setup.characters.size()), each, path);
    if (!character) return character.error();
    setup.characters.push_back(std::move(*character));
  }
  const auto is_built_in = [](const CrowdCharacter& character) { return character.file.empty(); };
  if (setup.characters.size() > 1 && std::ranges::any_of(setup.characters, is_built_in)) {
    return file.wrong("the built-in character stands alone; give each of several characters a \"model\"");
  }
  return setup;
}

std::vector<CastEntry> entries_of(std::span<const CrowdCharacter> characters) {
  std::vector<CastEntry> entries;
  for (const CrowdCharacter& character : characters) {
    if (character.file.empty()) continue;
    entries.push_back({.file = character.file,
                       .share = character.share,
                       .clip_files = character.clip_files,
                       .placement = character.placement});
  }
  return entries;
}

anim::Status become(const CrowdCharacter& wanted, CharacterSource& character) {
  RecordedCharacter kept = recorded(character);
  kept.share = wanted.share;
  kept.rig = wanted.rig;
  kept.rules = wanted.rules;
  character.rules_are_chosen = wanted.rules.has_value();
  if (!wanted.bones.empty()) {
    kept.bones = wanted.bones;
    kept.level_counts = wanted.level_counts;
  }
  const anim::Status chosen = choose_clips(wanted.clips, character.clip_names, kept.roles);
  if (!chosen) return anim::Error{character.name + ": " + chosen.error().message};
  return become_recorded(kept, character);
}

}  // namespace throng::app
