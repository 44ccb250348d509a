#include "app/show/request/crowd_command.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "app/character/role_table.h"
#include "app/character/skin_choice.h"
#include "app/settings/choices.h"
#include "app/settings/option_values.h"
#include "app/settings/track_values.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

bool is_plain_letter(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
         std::string_view("_./,=+-:@%").find(letter) != std::string_view::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, is_plain_letter)) return word;
  std::string in_quotes = "'";
  for (const char letter : word) in_quotes += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return in_quotes + "'";
}

/// Returns the name of a file as a word that is no option and no command.
std::string file_word(const std::string& file) {
  const bool is_plain_name = file.find_first_of("./") != std::string::npos && !file.starts_with('-');
  return is_plain_name || file.empty() || file == "-" ? file : "./" + file;
}

bool has_any_of(const std::string& text, const char* letters) {
  return text.find_first_of(letters) != std::string::npos;
}

/// Returns the roles that options have to say, so that a character which is loaded anew plays its clips; nothing where
/// its file of roles cannot be read.
std::optional<std::vector<std::string>> changed_roles(const CharacterSource& person) {
  const auto kept = RoleFile(person.file).read();
  RoleClips loaded = person.suggested;
  if (!kept || !choose_clips(*kept, person.clip_names, loaded)) return {};
  const auto now = all_choices(person.roles.clips, person.clip_names);
  std::vector<std::string> changed;
  for (std::size_t role = 0; role < now.size(); ++role) {
    if (person.roles.clips.at(role) == loaded.at(role)) continue;
    if (has_any_of(now[role].clip, ",")) return {};
    changed.push_back(std::string(role_names.at(role)) + "=" + now[role].clip);
  }
  return changed;
}

/// Returns whether a character that is loaded by its name has the order of bones, the body and the rules that it has
/// now.
bool is_as_loaded(const CharacterSource& person) {
  const auto kept = RoleFile(character_file(person.file).path).read_rig();
  return !person.rules_are_chosen && !person.order_is_chosen && kept && *kept == person.rig;
}

/// Returns whether options name the characters, with all that was chosen for them. Some options hold for all
/// characters, and --clips would change the roles of each.
bool are_said_by_options(std::span<const CharacterSource> people, bool has_tracks) {
  const CharacterSource& first = people.front();
  const anim::PlacementChoice& placement = first.placement.choice;
  const bool up_is_of_tracks = has_tracks && first.file.empty() && placement.up != anim::PlacementChoice().up;
  const auto is_said = [&](const CharacterSource& person) {
    const auto roles = changed_roles(person);
    const auto is_name = [](const std::string& file) { return !has_any_of(file, ","); };
    return is_as_loaded(person) && roles && (roles->empty() || people.size() == 1) &&
           person.clip_files == first.clip_files && person.placement.choice == placement &&
           person.roles.share >= least_share && !has_any_of(person.file, ",*") &&
           std::ranges::all_of(person.clip_files, is_name);
  };
  return !up_is_of_tracks && std::ranges::all_of(people, is_said);
}

void add_models(std::span<const CharacterSource> people, std::vector<std::string>& words) {
  if (people.front().file.empty()) return;
  const bool has_shares = std::ranges::any_of(people, [](const auto& person) { return person.roles.share != 1.0; });
  std::vector<std::string> cast;
  for (const CharacterSource& person : people) {
    const std::string file = file_word(person.file);
    if (!has_shares) words.push_back(quoted(file));
    cast.push_back(file + "*" + shortest_text(person.roles.share));
  }
  if (has_shares) words.insert(words.end(), {"--cast", quoted(joined(cast, ",", ","))});
}

void add_what_all_share(const CharacterSource& first, std::vector<std::string>& words) {
  std::vector<std::string> clip_files;
  for (const std::string& file : first.clip_files) clip_files.push_back(file_word(file));
  if (!clip_files.empty()) words.insert(words.end(), {"--clips-from", quoted(joined(clip_files, ",", ","))});
  const anim::PlacementChoice& asked = first.placement.choice;
  if (asked.scale) words.insert(words.end(), {"--scale", shortest_text(*asked.scale)});
  if (asked.ground != anim::PlacementChoice().ground) {
    words.insert(words.end(), {"--ground", ground_words.at(static_cast<std::size_t>(asked.ground))});
  }
}

void add_characters(std::span<const CharacterSource> people, std::vector<std::string>& words) {
  add_models(people, words);
  add_what_all_share(people.front(), words);
  const auto roles = changed_roles(people.front());
  if (roles && !roles->empty()) words.insert(words.end(), {"--clips", quoted(joined(*roles, ",", ","))});
}

std::string name_of_tracks(const TrajectoryOptions& tracks) { return fs::path(tracks.file).stem().string(); }

/// Returns whether options name the recorded crowd. `--up` may name its axis beside that of models, and the scene that
/// such options show is the recorded crowd.
bool are_said_by_options(const CrowdSetup& setup, bool says_characters) {
  const TrajectoryOptions& tracks = setup.trajectories;
  const bool says_axis = says_characters && !has_any_of(name_of_tracks(tracks), ",=");
  return !tracks.file.empty() && setup.preset.tuning.scene == Scene::tracks &&
         (says_axis || tracks.reading.up == TrackReading().up);
}

void add_tracks(const CrowdSetup& setup, std::vector<std::string>& words) {
  for (const TrackValue& value : track_values()) {
    const std::string text = value.text(setup.trajectories);
    if (text.empty() || value.option.empty()) continue;
    if (!value.is_flag()) {
      const bool is_file = value.form == TrackValue::Form::file_name;
      words.insert(words.end(), {value.option_name(), quoted(is_file ? file_word(text) : text)});
    } else {
      words.push_back(value.option_name() + (value.hint().empty() ? "" : "=" + text));
    }
  }
  if (setup.trajectories.file == "-") {
    words.insert(words.end(), {"--agents", std::to_string(setup.preset.tuning.agents)});
  }
}

void add_axes(const CharacterSource* first, const TrajectoryOptions* tracks, std::vector<std::string>& words) {
  std::vector<std::string> axes;
  const anim::UpAxis up = first != nullptr ? first->placement.choice.up : anim::PlacementChoice().up;
  if (up != anim::PlacementChoice().up) axes.emplace_back(up_axis_words.at(static_cast<std::size_t>(up)));
  if (tracks != nullptr && tracks->reading.up == TrackUp::y) axes.push_back(name_of_tracks(*tracks) + "=y");
  if (!axes.empty()) words.insert(words.end(), {"--up", quoted(joined(axes, ",", ","))});
}

void add_camera(const CrowdSetup& setup, std::vector<std::string>& words) {
  if (!setup.camera_name.empty()) words.insert(words.end(), {"--camera", quoted(setup.camera_name)});
  if (!setup.camera_path.empty()) {
    const bool is_file = setup.camera_path.ends_with(".csv");
    words.insert(words.end(), {"--camera-path", quoted(is_file ? file_word(setup.camera_path) : setup.camera_path)});
  }
}

}  // namespace

std::string crowd_command(const CrowdSetup& setup, std::span<const CharacterSource> people) {
  std::set<std::string> said{"version", "values", "camera_name", "camera_path"};
  std::vector<std::string> words{"throng"};
  const bool says_characters = are_said_by_options(people, !setup.trajectories.file.empty());
  const bool says_tracks = are_said_by_options(setup, says_characters);
  Tuning usual;
  if (says_characters) {
    said.insert("characters");
    add_characters(people, words);
  }
  if (says_tracks) {
    said.insert("trajectories");
    usual.scene = Scene::tracks;
    add_tracks(setup, words);
  }
  add_axes(says_characters ? &people.front() : nullptr, says_tracks ? &setup.trajectories : nullptr, words);
  const bool has_name = !setup.camera_name.empty();
  words.push_back(command_line(setup.preset.tuning, usual, has_name ? std::nullopt : setup.preset.camera));
  add_camera(setup, words);
  Json rest = Json::object();
  const Json all = to_json(setup);
  for (const auto& [key, value] : all.members()) {
    if (!said.contains(key)) rest[key] = value;
  }
  if (!rest.members().empty()) words.insert(words.end(), {"--crowd", quoted(rest.dump())});
  return joined(words, " ", " ");
}

}  // namespace throng::app
