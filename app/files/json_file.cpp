#include "app/files/json_file.h"

#include <optional>
#include <utility>

#include "engine/anim/import/json/json_object.h"
#include "engine/files/input_file.h"

namespace throng::app {

JsonFile::JsonFile(std::filesystem::path file, JsonRemedies remedies) : file_(std::move(file)), remedies_(remedies) {}

anim::Result<Json> JsonFile::read() const {
  const auto text = read_text(file_, "a file of JSON", most_json_bytes);
  if (!text) return anim::Error{file_.string() + ": " + text.error().message + std::string(remedies_.unread)};
  auto json = parse_json(*text);
  if (!json) return anim::Error{file_.string() + ": " + json.error().message + std::string(remedies_.malformed)};
  return json;
}

anim::Error JsonFile::wrong(const std::string& what) const {
  return {file_.string() + ": " + what + std::string(remedies_.wrong)};
}

anim::Status JsonFile::check_table(const Json& table, int version, std::initializer_list<std::string_view> keys) const {
  std::optional<std::string> complaint;
  const JsonObject reader("", table, keys, complaint);
  const Json& found = table["version"];
  if (!found.is_number() || found.get<double>() != version) reader.wrong("version", std::to_string(version));
  return complaint ? anim::Status(wrong(*complaint)) : anim::Done{};
}

}  // namespace throng::app
