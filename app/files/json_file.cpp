#include "app/files/json_file.h"

#include <utility>

#include "engine/base/files/input_file.h"

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

}  // namespace throng::app
