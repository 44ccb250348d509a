#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace throng::test {

/// A folder below the system's temporary one (TMPDIR) that nobody else uses. It is empty at first and gone at the end.
class OwnFolder {
 public:
  OwnFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "throng-XXXXXX").string();  // mkdtemp fills the Xs
    if (mkdtemp(pattern.data()) == nullptr) std::abort();
    path_ = pattern;
  }
  ~OwnFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace throng::test
