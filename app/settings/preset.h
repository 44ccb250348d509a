#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/json.h"
#include "app/settings/option_values.h"
#include "app/settings/settings.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Values under a name: what a person tuned, to come back to or to hand on.
struct Preset {
  Tuning tuning;
  std::optional<CameraPlace> camera;  ///< none: the camera stays where it is
};

/// One flat JSON object; the keys are those of tuning_values() and "camera" (x,y,z,yaw,pitch,fov as `--camera` has
/// them, in a string). Missing keys keep what `preset` has. The complaint names the key and what to do, and then
/// nothing has changed.
Json to_json(const Preset& preset);
Complaint from_json(const Json& json, Preset& preset);
/// As from_json(); also complains of what is no JSON.
Complaint from_json_text(std::string_view text, Preset& preset);

/// Missing keys are the defaults. The error is one line that names file, key and what to do.
anim::Result<Preset> read_preset(const std::filesystem::path& file);
/// Whole or not at all; makes the folder.
anim::Status write_preset(const std::filesystem::path& file, const Preset& preset);

/// Where presets with a name lie: $XDG_CONFIG_HOME/throng/presets, else ~/.config/throng/presets; empty if the system
/// names neither.
std::filesystem::path preset_folder();
/// NAME.json in it. What has a dot or slash is a file of its own.
std::filesystem::path preset_file(const std::string& name_or_file);
/// Of the presets in the folder, sorted.
std::vector<std::string> preset_names();

/// The name or file of a preset, as `--preset` takes it.
ValueReader preset_values(DemoOptions& options);

/// KEY=VALUE,... of tuning_values(), as `--set` takes them.
ValueReader set_values(Tuning& tuning);

/// The options that make `tuning` of `defaults`, and the camera: "--agents 5000 --set full_rate_distance=20
/// --camera 0,2,9,0,-5,50". Only what differs; empty if nothing does.
std::string command_line(const Tuning& tuning, const Tuning& defaults, const std::optional<CameraPlace>& camera);

/// As `--camera` takes it: x,y,z,yaw,pitch,fov.
std::string camera_text(const CameraPlace& place);

}  // namespace throng::app
