#include "app/recording/recording.h"

#include <nlohmann/json.hpp>

#include "app/settings/preset.h"

namespace throng::app {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json json_of(const Tuning& tuning) { return Json::parse(to_json(Preset{.tuning = tuning, .camera = {}})); }

bool is_between(const Json& json, int least, int most) {
  return json.is_number_integer() && json.get<std::int64_t>() >= least && json.get<std::int64_t>() <= most;
}

}  // namespace

std::string changed_values(const Tuning& before, const Tuning& tuning) {
  const Json old_values = json_of(before);
  const Json values = json_of(tuning);
  Json changed = Json::object();
  for (const auto& [key, value] : values.items()) {
    if (old_values[key] != value) changed[key] = value;
  }
  return dumped(changed);
}

std::string header_text(const RecordingHeader& header) {
  Json json;
  json["width"] = header.width;
  json["height"] = header.height;
  json["characters"] = Json::parse(to_json(header.characters));
  json["tuning"] = json_of(header.tuning);
  return dumped(json);
}

std::optional<std::string> read_header(std::string_view text, RecordingHeader& header) {
  const Json json = Json::parse(text, nullptr, false);
  const auto has = [&](const char* key) { return json.is_object() && json.contains(key); };
  if (!has("width") || !has("height") || !has("characters") || !has("tuning")) return "has a header that is none";
  if (!is_between(json["width"], 1, most_picture_pixels) || !is_between(json["height"], 1, most_picture_pixels)) {
    return "has a header with a picture of no size";
  }
  if (!from_json(dumped(json["characters"]), header.characters)) return "has a header with characters that are none";
  Preset preset;
  if (const Complaint complaint = from_json(dumped(json["tuning"]), preset))
    return "has a header in which " + *complaint;
  header.tuning = preset.tuning;
  header.width = json["width"].get<int>();
  header.height = json["height"].get<int>();
  return {};
}

}  // namespace throng::app
