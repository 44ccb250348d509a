#include "app/settings/preset.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "app/files/kept_file.h"
#include "app/settings/tuning_values.h"
#include "engine/base/files/input_file.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t most_bytes = 65536;

// The text of a value on a command line; nothing for a value without one.
std::optional<std::string> text_of(const Json& value) {
  if (value.is<std::string>()) return value.get<std::string>();
  if (value.is<bool>()) return value.get<bool>() ? "on" : "off";
  if (value.is_number()) return value.dump();
  return {};
}

Complaint take_key(const std::string& key, const Json& value, Preset& preset) {
  if (key == "camera") return read_camera_pose(key, value, preset.camera);
  const TuningValue* const row = find_tuning_value(key);
  if (row == nullptr) return "unknown key \"" + key + "\"; it knows camera, " + known_preset_keys();
  return take_value([&](const std::string& text) { return row->read(preset.tuning, text); }, key, value);
}

Json json_of(const TuningValue& row, const Tuning& tuning) {
  const std::string text = row.text(tuning);
  if (row.form == TuningValue::Form::on_off) return text == "on";
  return row.form == TuningValue::Form::word ? Json(text) : *parse_json(text);
}

Complaint read_into(const fs::path& file, Preset& preset) {
  const auto text = read_text(file, "a preset", most_bytes);
  return text ? from_json_text(*text, preset) : Complaint(text.error().message);
}

bool may_stand_in_a_name(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == ' ' || letter == '-' || letter == '_';
}

// The defaults under the options of `tuning`: `--lod off` also turns off all that saves work.
Tuning settled(Tuning defaults, const Tuning& tuning) {
  if (tuning.lod.rule != LodRule::off || defaults.lod.rule == LodRule::off) return defaults;
  defaults.lod.bone_lod = defaults.lod.smooth = false;
  defaults.mesh_lod = 0;
  return defaults;
}

}  // namespace

Complaint take_value(const ValueReader& reader, const std::string& key, const Json& value) {
  const std::optional<std::string> text = text_of(value);
  if (!text) return "\"" + key + "\" must be a number, a word, true or false";
  const Complaint complaint = reader(*text);
  return complaint ? Complaint("\"" + key + "\" " + *complaint) : Complaint();
}

Json to_json(const Preset& preset) {
  Json json;
  for (const TuningValue& row : tuning_values()) json[std::string(row.key)] = json_of(row, preset.tuning);
  if (preset.camera) json["camera"] = camera_text(*preset.camera);
  return json;
}

Complaint read_camera_pose(const std::string& key, const Json& json, std::optional<CameraPose>& place) {
  DemoOptions options;
  Complaint complaint = take_value(camera(options), key, json);
  if (!complaint && !options.camera) complaint = "\"" + key + "\" must be x,y,z,yaw,pitch[,fov] in a string";
  if (!complaint) place = options.camera;
  return complaint;
}

Complaint from_json_text(std::string_view text, Preset& preset) {
  const auto json = parse_json(text);
  return json ? from_json(*json, preset) : Complaint(json.error().message + "; mend it there");
}

Complaint from_json(const Json& json, Preset& preset) {
  if (!json.is_object()) return "must be a JSON object of keys and values";
  Preset taken = preset;
  for (const auto& [key, value] : json.members()) {
    if (Complaint complaint = take_key(key, value, taken)) return complaint;
  }
  preset = taken;
  return {};
}

Result<Preset> read_preset(const fs::path& file) {
  Preset preset;
  if (const Complaint complaint = read_into(file, preset)) return Error{file.string() + ": " + *complaint};
  return preset;
}

Status write_preset(const fs::path& file, const Preset& preset) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  return write_whole_file(file, to_json(preset).dump(2) + "\n");
}

fs::path preset_folder() {
  const fs::path folder = configuration_folder();
  return folder.empty() ? folder : folder / "presets";
}

fs::path preset_file(const std::string& name_or_file) {
  const bool is_file = name_or_file.find_first_of("/.") != std::string::npos;
  return is_file ? fs::path(name_or_file) : preset_folder() / (name_or_file + ".json");
}

bool can_name_a_preset(const std::string& name) {
  return !name.empty() && name.front() != ' ' && name.back() != ' ' && std::ranges::all_of(name, may_stand_in_a_name);
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(preset_folder(), error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".json") names.push_back(entry->path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

ValueReader preset_values(DemoOptions& options) {
  return [&options](const std::string& text) -> Complaint {
    const fs::path file = preset_file(text);
    Preset preset{.tuning = options.tuning, .camera = options.camera};
    if (const Complaint complaint = read_into(file, preset)) {
      return file == text ? complaint : Complaint(file.string() + ": " + *complaint);
    }
    options.tuning = preset.tuning;
    options.camera = preset.camera;
    options.preset = file.string();
    options.values_given.all = true;
    return {};
  };
}

ValueReader set_values(DemoOptions& options) {
  return [&options](const std::string& text) -> Complaint {
    Tuning taken = options.tuning;
    std::vector<std::string> keys;
    for (const std::string& part : parts_between_commas(text)) {
      const std::size_t equals = std::min(part.find('='), part.size());
      const std::string key = part.substr(0, equals);
      const TuningValue* const row = find_tuning_value(key);
      if (equals == part.size()) return "must be KEY=VALUE, with commas between several";
      if (row == nullptr) return "there is no key " + key + "; keys are " + known_preset_keys();
      if (const Complaint complaint = row->read(taken, part.substr(equals + 1))) return key + " " + *complaint;
      keys.push_back(key);
    }
    options.tuning = taken;
    std::ranges::move(keys, std::back_inserter(options.values_given.keys));
    return {};
  };
}

std::string command_line(const Tuning& tuning, const Tuning& defaults, const std::optional<CameraPose>& camera) {
  const Tuning expected = settled(defaults, tuning);
  std::string line, set;
  for (const TuningValue& row : tuning_values()) {
    const std::string text = row.text(tuning);
    if (text == row.text(expected) && !row.device_decides) continue;
    if (tuning.scene == Scene::tracks && row.key == "agents") continue;  // the file has as many as it has
    const bool option_says_it = !row.option.empty() && !row.option_does_more && (text != "0" || row.zero.empty());
    if (option_says_it) {
      line.append(line.empty() ? "" : " ").append(row.option_name()).append(" ").append(text);
    } else {
      set.append(set.empty() ? "--set " : ",").append(row.key).append("=").append(text);
    }
  }
  if (!set.empty()) line.append(line.empty() ? "" : " ").append(set);
  if (camera) line.append(line.empty() ? "" : " ").append("--camera ").append(camera_text(*camera));
  return line;
}

std::string camera_text(const CameraPose& place) {
  std::string text;
  for (const float number : {place.x, place.y, place.z, place.yaw, place.pitch, place.field_of_view}) {
    text.append(text.empty() ? "" : ",").append(shortest_text(number));
  }
  return text;
}

}  // namespace throng::app
