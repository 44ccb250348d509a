#include "app/recording/recording.h"

#include "app/settings/preset.h"

namespace throng::app {
namespace {

Json json_of(const Tuning& tuning) { return to_json(Preset{.tuning = tuning, .camera = {}}); }

}  // namespace

std::string changed_values(const Tuning& before, const Tuning& tuning) {
  const Json old_values = json_of(before);
  const Json values = json_of(tuning);
  Json changed = Json::object();
  for (const auto& [key, value] : values.members()) {
    if (old_values[key] != value) changed[key] = value;
  }
  return changed.dump();
}

std::string header_text(const RecordingHeader& header) {
  const Json json = {{"width", header.width},
                     {"height", header.height},
                     {"characters", to_json(header.characters)},
                     {"tuning", json_of(header.tuning)}};
  return json.dump();
}

std::optional<std::string> read_header(std::string_view text, RecordingHeader& header) {
  const auto read = parse_json(text);
  const auto has = [&](const char* key) { return read && read->contains(key); };
  if (!has("width") || !has("height") || !has("characters") || !has("tuning")) return "has a header that is none";
  const Json& json = *read;
  if (!json["width"].is_whole(1, most_picture_pixels) || !json["height"].is_whole(1, most_picture_pixels)) {
    return "has a header with a picture of no size";
  }
  if (!from_json(json["characters"], header.characters)) return "has a header with characters that are none";
  Preset preset;
  if (const Complaint complaint = from_json(json["tuning"], preset)) return "has a header in which " + *complaint;
  header.tuning = preset.tuning;
  header.width = json["width"].get<int>();
  header.height = json["height"].get<int>();
  return {};
}

}  // namespace throng::app
