#include "app/files/kept_file.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "engine/base/files/output_file.h"
#include "engine/base/files/process.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

bool can_write_beside(const fs::path& file) {
  const fs::path folder = file.parent_path();
  return !file.empty() && may_write(folder.empty() ? "." : folder);
}

}  // namespace

fs::path configuration_folder() {
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && fs::path(config).is_absolute()) return fs::path(config) / "throng";
  const char* const home = std::getenv("HOME");
  return home == nullptr || *home == '\0' ? fs::path() : fs::path(home) / ".config" / "throng";
}

KeptFile::KeptFile(const fs::path& model, std::string_view ending, std::string_view what) : what_(what) {
  const std::string name = (model.empty() ? "mannequin" : model.filename().string()).append(ending);
  if (!model.empty()) beside_ = model.parent_path() / name;
  const fs::path folder = configuration_folder();
  if (!folder.empty()) own_ = folder / name;
}

fs::path KeptFile::found() const {
  std::error_code error;
  if (!can_write_beside(beside_) && !own_.empty() && fs::exists(own_, error)) return own_;
  return !beside_.empty() && fs::exists(beside_, error) ? beside_ : fs::path();
}

Result<fs::path> KeptFile::write(std::string_view text) const {
  const bool beside = can_write_beside(beside_);
  const fs::path file = beside ? beside_ : own_;
  if (file.empty()) {
    const std::string whose = beside_.empty() ? std::string(what_) : beside_.string();
    return Error{whose + ": cannot be written, and neither XDG_CONFIG_HOME nor HOME names a folder"};
  }
  std::error_code error;
  if (!beside) fs::create_directories(file.parent_path(), error);
  const Status written = write_whole_file(file, text);
  if (!written) return written.error();
  return file;
}

}  // namespace throng::app
