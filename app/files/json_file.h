#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/base/json/json.h"

namespace throng::app {

/// The remedies that complaints end with: for a missing file, for a file that is not JSON, and for wrong contents.
struct JsonRemedies {
  std::string_view unread = {}, malformed = "mend it there", wrong = {};
};

/// A file of JSON that people may write by hand. Every complaint is one sentence that begins with the file's name.
class JsonFile {
 public:
  explicit JsonFile(std::filesystem::path file, JsonRemedies remedies = {});

  Result<Json> read() const;
  Error wrong(const std::string& what) const;

 private:
  std::filesystem::path file_;
  JsonRemedies remedies_;
};

/// Returns the name of a file as a text, or as a list of its bytes where they are no UTF-8, which JSON demands.
Json name_json(const std::string& file);
/// Reads such a name. Returns whether it is one.
bool read_name(const Json& json, std::string& file);

}  // namespace throng::app
