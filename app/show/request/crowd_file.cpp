#include "app/show/request/crowd_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/character/skin_choice.h"
#include "app/files/json_file.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json_object.h"

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
  const CharacterFile named = character_file(file);
  const fs::path relative = whole_path(named.path).lexically_relative(whole_path(folder));
  return with_skin(relative.empty() ? whole_path(named.path).string() : relative.generic_string(), named.skin);
}

std::string found_from(const fs::path& folder, const std::string& file) {
  const CharacterFile named = character_file(file);
  return with_skin((folder / named.path).lexically_normal().string(), named.skin);
}

/// Does `change(file)` to the name of each file of a character.
template <typename Change>
ChosenCharacter with_files(ChosenCharacter character, const Change& change) {
  if (!character.file.empty()) character.file = change(character.file);
  for (std::string& file : character.clip_files) file = change(file);
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
    if (const Complaint wrong = read_camera_pose(digit, object[digit], bookmarks.at(i))) object.complain(*wrong);
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
  for (const CharacterSource& person : people) setup.characters.push_back(chosen(person));
  return setup;
}

Status write_crowd_file(const fs::path& file, const CrowdSetup& setup) {
  const auto relative = [&](const std::string& name) { return relative_to(file.parent_path(), name); };
  Json characters = Json::array();
  for (const ChosenCharacter& character : setup.characters) {
    characters.push_back(to_json(with_files(character, relative)));
  }
  Json json = {
      {"version", crowd_file_version}, {"characters", std::move(characters)}, {"values", to_json(setup.preset)}};
  if (setup.pair != TuningPair()) json["compare"] = to_json(setup.pair);
  if (setup.bookmarks != CameraBookmarks()) json["bookmarks"] = bookmarks_json(setup.bookmarks);
  return write_whole_file(file, json.dump(2) + "\n");
}

Result<CrowdSetup> read_crowd_file(const fs::path& path) {
  const JsonFile file(path);
  const auto json = file.read();
  if (!json) return json.error();
  std::optional<std::string> complaint;
  const JsonObject object("", *json, {"version", "characters", "values", "compare", "bookmarks"}, complaint);
  object.version(crowd_file_version);
  object.need({"characters"});
  CrowdSetup setup;
  if (!complaint && json->contains("values")) complaint = from_json((*json)["values"], setup.preset);
  if (!complaint && json->contains("compare")) complaint = from_json((*json)["compare"], setup.pair);
  if (json->contains("bookmarks")) read_bookmarks((*json)["bookmarks"], complaint, setup.bookmarks);
  if (!complaint) setup.characters = read_characters(object["characters"], complaint);
  if (complaint) return file.wrong(*complaint);
  const auto found = [&](const std::string& name) { return found_from(path.parent_path(), name); };
  for (ChosenCharacter& character : setup.characters) character = with_files(std::move(character), found);
  return setup;
}

}  // namespace throng::app
