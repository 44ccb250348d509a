#include "app/files/json_file.h"

#include <utility>

#include "engine/base/files/input_file.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

std::string ending(std::string_view remedy) { return remedy.empty() ? "" : "; " + std::string(remedy); }

}  // namespace

JsonFile::JsonFile(std::filesystem::path file, JsonRemedies remedies) : file_(std::move(file)), remedies_(remedies) {}

Result<Json> JsonFile::read() const {
  const auto text = read_text(file_, "a file of JSON", most_json_bytes);
  if (!text) return Error{file_.string() + ": " + text.error().message + ending(remedies_.unread)};
  auto json = parse_json(*text);
  if (!json) return Error{file_.string() + ": " + json.error().message + ending(remedies_.malformed)};
  return json;
}

Error JsonFile::wrong(const std::string& what) const {
  return {file_.string() + ": " + what + ending(remedies_.wrong)};
}

Json name_json(const std::string& file) {
  if (is_utf8(file)) return file;
  Json bytes = Json::array();
  for (const char byte : file) bytes.push_back(static_cast<int>(static_cast<unsigned char>(byte)));
  return bytes;
}

bool read_name(const Json& json, std::string& file) {
  constexpr int most_byte = 255;
  if (json.is<std::string>()) {
    file = json.get<std::string>();
  } else if (json.are_whole(1, most_byte)) {
    file.clear();
    for (const Json& byte : json.elements()) file += static_cast<char>(byte.get<int>());
  } else {
    return false;
  }
  return file.find('\0') == std::string::npos;
}

}  // namespace throng::app
