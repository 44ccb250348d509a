#include "app/show/recording/recording.h"

#include "app/settings/preset.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
std::string header_text(const RecordingHeader& header) {
  const Json json = {{"width", header.width},
                     {"height", header.height},
                     {"characters", to_json(header.characters)},
                     {"tuning", to_json(Preset{.tuning = header.tuning, .camera = {}})}};
  return json.dump();
}

std::optional<std::string> read_header(std::string_view text, RecordingHeader& header) {
  const auto json = parse_json(text);
  if (!json) return json.error().message;
  std::optional<std::string> complaint;
  const JsonObject reader("", *json, {"width", "height", "characters", "tuning"}, complaint);
  reader.need({"width", "height", "characters", "tuning"});
  reader.whole("width", header.width, 1, most_picture_pixels);
  reader.whole("height", header.height, 1, most_picture_pixels);
  header.characters = read_characters(reader["characters"], complaint);
  Preset preset;
  if (!complaint) complaint = from_json(reader["tuning"], preset);
  header.tuning = preset.tuning;
  return complaint;
}

}  // namespace throng::app
