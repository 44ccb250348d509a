#include "app/settings/user_settings.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "app/files/json_file.h"
#include "app/files/kept_file.h"
#include "app/settings/option_values.h"
#include "app/settings/quality.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;
constexpr int settings_version = 1;
constexpr int most_panel_width = 100000;  // no screen has as many pixels
constexpr JsonRemedies remedies{.malformed = "delete the file", .wrong = "delete the file"};

void read_size(const JsonObject& object, UserSettings& settings) {
  std::string size;
  object.text("size", size);
  const Complaint wrong = size.empty() ? Complaint() : image_size(settings.width, settings.height)(size);
  if (wrong) object.complain("\"size\" " + *wrong);
}

void read_quality(const JsonObject& object, UserSettings& settings) {
  object.text("quality", settings.quality);
  DemoOptions unused;
  const Complaint wrong = settings.quality.empty() ? Complaint() : quality(unused)(settings.quality);
  if (wrong) object.complain("\"quality\" " + *wrong);
}

void read_output(const JsonObject& object, OutputChoices& output) {
  object.whole("picture_times", output.picture_times, 1, most_picture_times);
  object.number("video_seconds", output.video_seconds, least_video_seconds, most_video_seconds);
}

bool is_given(const DemoOptions& options, const char* option) {
  return std::ranges::find(options.given, option) != options.given.end();
}

}  // namespace

fs::path user_settings_file() {
  const fs::path folder = configuration_folder();
  return folder.empty() ? fs::path() : folder / "settings.json";
}

Result<UserSettings> read_user_settings(const fs::path& path) {
  std::error_code error;
  UserSettings settings;
  if (path.empty() || !fs::exists(path, error)) return settings;
  const JsonFile file(path, remedies);
  const auto json = file.read();
  if (!json) return json.error();
  std::optional<std::string> complaint;
  const JsonObject object(
      "", *json, {"version", "quality", "size", "panel_width", "recent_files", "picture_times", "video_seconds"},
      complaint);
  object.version(settings_version);
  read_size(object, settings);
  read_quality(object, settings);
  object.whole("panel_width", settings.panel_width, 0, most_panel_width);
  object.texts("recent_files", settings.recent_files);
  read_output(object, settings.output);
  if (complaint) return file.wrong(*complaint);
  return settings;
}

Status write_user_settings(const fs::path& file, const UserSettings& settings) {
  Json json = {{"version", settings_version}};
  if (!settings.quality.empty()) json["quality"] = settings.quality;
  if (settings.width > 0) json["size"] = std::to_string(settings.width) + "x" + std::to_string(settings.height);
  if (settings.panel_width > 0) json["panel_width"] = settings.panel_width;
  if (!settings.recent_files.empty()) json["recent_files"] = settings.recent_files;
  const OutputChoices usual;
  if (settings.output.picture_times != usual.picture_times) json["picture_times"] = settings.output.picture_times;
  if (settings.output.video_seconds != usual.video_seconds) json["video_seconds"] = settings.output.video_seconds;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  return write_whole_file(file, json.dump(2) + "\n");
}

void take_user_settings(const UserSettings& settings, DemoOptions& options) {
  if (settings.width > 0 && !is_given(options, "--size")) {
    options.width = settings.width;
    options.height = settings.height;
  }
  const auto is_said = [&](const char* key) { return options.values_given.has(key); };
  if (settings.quality.empty() || is_said("holds_rate") || std::ranges::any_of(picture_cost_keys, is_said)) return;
  static_cast<void>(quality(options)(settings.quality));
}

}  // namespace throng::app
