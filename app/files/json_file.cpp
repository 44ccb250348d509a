#include "app/files/json_file.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include "app/files/joined.h"

namespace throng::app {

std::optional<std::string> read_text(const std::filesystem::path& file, std::size_t most_bytes) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {};
  std::string text;
  std::string piece(65536, '\0');
  while (text.size() <= most_bytes && stream) {
    stream.read(piece.data(), static_cast<std::streamsize>(std::min(piece.size(), most_bytes + 1 - text.size())));
    text.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

JsonFile::JsonFile(std::filesystem::path file, JsonRemedies remedies) : file_(std::move(file)), remedies_(remedies) {}

anim::Result<Json> JsonFile::read() const {
  const std::optional<std::string> text = read_text(file_, most_json_bytes);
  if (!text) return anim::Error{file_.string() + ": cannot be read" + std::string(remedies_.unread)};
  auto json = parse_json(*text);
  if (!json) return anim::Error{file_.string() + ": " + json.error().message + std::string(remedies_.malformed)};
  return json;
}

anim::Error JsonFile::wrong(const std::string& what) const {
  return {file_.string() + ": " + what + std::string(remedies_.wrong)};
}

anim::Status JsonFile::check_table(const Json& table, int version, std::initializer_list<std::string_view> keys) const {
  if (!table.is_object()) return wrong("must be an object with \"" + joined(keys, "\", \"", "\" and \"") + "\"");
  if (const Json::Member* const other = table.member_beside(keys)) {
    return wrong("unknown key \"" + other->key + "\"; it knows " + joined(keys));
  }
  const Json& found = table["version"];
  if (!found.is_number() || found.get<double>() != version) {
    return wrong("\"version\" must be " + std::to_string(version));
  }
  return anim::Done{};
}

}  // namespace throng::app
