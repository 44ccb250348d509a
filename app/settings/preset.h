#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/settings/option_values.h"
#include "app/settings/settings.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// The values that a person tuned, to come back to or to hand on.
struct Preset {
  Tuning tuning;
  std::optional<CameraPose> camera;  ///< none: the camera stays where it is
};

/// Returns one flat JSON object with the keys of tuning_values() and "camera" (x,y,z,yaw,pitch,fov as `--camera` has
/// them, in a string).
Json to_json(const Preset& preset);
/// Reads an object of to_json() into `preset`. Keys that are missing leave `preset` as it is. A complaint names the key
/// and what is allowed; then nothing has changed.
Complaint from_json(const Json& json, Preset& preset);
/// Reads a number, a word, true or false by the reader of its text. A complaint names the key.
Complaint take_value(const ValueReader& reader, const std::string& key, const Json& value);
/// Reads the place of a camera, as "camera" has it. A complaint names the key.
Complaint read_camera_pose(const std::string& key, const Json& json, std::optional<CameraPose>& place);
/// Reads a text, which may not be JSON, as from_json() does.
Complaint from_json_text(std::string_view text, Preset& preset);

/// Reads a preset from a file. Keys that are missing have their defaults. The error is one line that names the file,
/// the key and what is allowed.
Result<Preset> read_preset(const std::filesystem::path& file);
/// Writes the file whole or not at all, and makes its folder.
Status write_preset(const std::filesystem::path& file, const Preset& preset);

/// Returns the folder of presets with a name: $XDG_CONFIG_HOME/throng/presets, else ~/.config/throng/presets; empty if
/// the system names neither.
std::filesystem::path preset_folder();
/// Returns NAME.json in that folder. A name with a dot or slash is a file of its own.
std::filesystem::path preset_file(const std::string& name_or_file);
/// Returns whether a preset can be kept under that name: letters, digits, blanks inside, - and _.
bool can_name_a_preset(const std::string& name);
/// Returns the names of the presets in the folder, sorted.
std::vector<std::string> preset_names();

/// Reads the name or file of a preset, as `--preset` takes it.
ValueReader preset_values(DemoOptions& options);

/// Reads KEY=VALUE,... of tuning_values(), as `--set` takes them.
ValueReader set_values(DemoOptions& options);

/// Returns the options that turn `defaults` into `tuning` and place the camera: "--agents 5000 --set
/// full_rate_distance=20 --camera 0,2,9,0,-5,50". Values that do not differ are left out.
std::string command_line(const Tuning& tuning, const Tuning& defaults, const std::optional<CameraPose>& camera);

/// Returns the text that `--camera` takes: x,y,z,yaw,pitch,fov.
std::string camera_text(const CameraPose& place);

}  // namespace throng::app
