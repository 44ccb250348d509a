#include "app/show/request/crowd_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/character/skin_choice.h"
#include "app/files/json_file.h"
#include "app/settings/track_values.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;
constexpr int crowd_file_version = 1;
constexpr std::string_view standard_input_name = "-";

/// Returns the absolute path of a folder, without links where it can be told.
fs::path path_without_links(const fs::path& path) {
  std::error_code failed;
  const fs::path whole = fs::weakly_canonical(path, failed);
  return failed ? fs::absolute(path, failed) : whole;
}

std::string relative_to(const fs::path& folder, const std::string& file) {
  const fs::path relative = path_without_links(file).lexically_relative(path_without_links(folder));
  return relative.empty() ? path_without_links(file).string() : relative.generic_string();
}

std::string found_from(const fs::path& folder, const std::string& file) {
  return (folder / file).lexically_normal().string();
}

/// Does `change(file)` to the name of each file of a setup.
template <typename Change>
CrowdSetup with_files(CrowdSetup setup, const Change& change) {
  const auto change_one = [&](std::string& file) {
    if (!file.empty()) file = change(file);
  };
  const auto change_model = [&](std::string& file) {
    const CharacterFile named = character_file(file);
    if (!file.empty()) file = with_skin(change(named.path), named.skin);
  };
  for (ChosenCharacter& character : setup.characters) {
    change_model(character.file);
    std::ranges::for_each(character.clip_files, change_model);
  }
  if (setup.trajectories.file != standard_input_name) change_one(setup.trajectories.file);
  change_one(setup.trajectories.reading.walls);
  if (setup.camera_path.ends_with(".csv")) change_one(setup.camera_path);
  return setup;
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

void read_trajectory_values(const Json& json, std::optional<std::string>& complaint, TrajectoryOptions& tracks) {
  if (const Complaint wrong = from_json(json, tracks); wrong && !complaint) complaint = "\"trajectories\": " + *wrong;
}

/// Reads a text as an option takes it.
void read_option(const JsonObject& object, const std::string& key, const ValueReader& reader, std::string& text) {
  if (!object.has(key)) return;
  object.text(key, text);
  if (const Complaint wrong = reader(text)) object.complain("\"" + key + "\" " + *wrong);
}

std::optional<std::string> read_setup(const Json& json, bool is_file, CrowdSetup& setup) {
  std::optional<std::string> complaint;
  const JsonObject object(
      "", json,
      {"version", "characters", "trajectories", "values", "camera_name", "camera_path", "compare", "bookmarks"},
      complaint);
  if (is_file || object.has("version")) object.version(crowd_file_version);
  if (is_file) object.need({"characters"});
  if (!complaint && object.has("values")) complaint = from_json(object["values"], setup.preset);
  if (!complaint && object.has("compare")) complaint = from_json(object["compare"], setup.pair);
  DemoOptions read;
  read_option(object, "camera_name", any_text(read.camera_name), setup.camera_name);
  read_option(object, "camera_path", camera_path(read), setup.camera_path);
  if (object.has("trajectories")) read_trajectory_values(object["trajectories"], complaint, setup.trajectories);
  if (object.has("bookmarks")) read_bookmarks(object["bookmarks"], complaint, setup.bookmarks);
  if (!complaint && object.has("characters")) setup.characters = read_characters(object["characters"], complaint);
  return complaint;
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

Json to_json(const CrowdSetup& setup) {
  Json json = {{"version", crowd_file_version}, {"characters", to_json(std::span(setup.characters))}};
  if (!setup.trajectories.file.empty()) json["trajectories"] = to_json(setup.trajectories);
  json["values"] = to_json(setup.preset);
  if (!setup.camera_name.empty()) json["camera_name"] = setup.camera_name;
  if (!setup.camera_path.empty()) json["camera_path"] = setup.camera_path;
  if (setup.pair != TuningPair()) json["compare"] = to_json(setup.pair);
  if (setup.bookmarks != CameraBookmarks()) json["bookmarks"] = bookmarks_json(setup.bookmarks);
  return json;
}

void begin_with(const CrowdSetup& setup, DemoOptions& options) {
  options.tuning = setup.preset.tuning;
  options.trajectories = setup.trajectories;
  options.camera = setup.preset.camera;
  options.camera_name = setup.camera_name;
  options.camera_path = CameraPath::none;
  options.camera_path_file.clear();
  if (!setup.camera_path.empty()) static_cast<void>(camera_path(options)(setup.camera_path));
  options.crowd = std::make_shared<const CrowdSetup>(setup);
}

ValueReader crowd_text(DemoOptions& options) {
  return [&options](const std::string& text) -> Complaint {
    const auto json = parse_json(text);
    if (!json) return json.error().message;
    CrowdSetup setup{.characters = {}, .preset = {.tuning = options.tuning, .camera = options.camera}};
    if (Complaint wrong = read_setup(*json, false, setup)) return wrong;
    begin_with(setup, options);
    if (!json->contains("values")) return {};
    for (const auto& [key, value] : (*json)["values"].members()) options.values_given.keys.push_back(key);
    return {};
  };
}

Status write_crowd_file(const fs::path& file, const CrowdSetup& setup) {
  const auto relative = [&](const std::string& name) { return relative_to(file.parent_path(), name); };
  return write_whole_file(file, to_json(with_files(setup, relative)).dump(2) + "\n");
}

Result<CrowdSetup> read_crowd_file(const fs::path& path) {
  const JsonFile file(path);
  const auto json = file.read();
  if (!json) return json.error();
  CrowdSetup setup;
  if (const auto complaint = read_setup(*json, true, setup)) return file.wrong(*complaint);
  const auto found = [&](const std::string& name) { return found_from(path.parent_path(), name); };
  return with_files(std::move(setup), found);
}

}  // namespace throng::app
