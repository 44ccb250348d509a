#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/anim/asset/model.h"
#include "tests/own_folder.h"

namespace throng::import::testing {

/// Returns the path of tests/data/`name`.
std::filesystem::path data_path(const std::string& name);

nlohmann::json read_json(const std::filesystem::path& path);

std::vector<char> read_bytes(const std::filesystem::path& path);

/// Returns the names of the .glb and .gltf files of a folder, sorted.
std::vector<std::string> model_files(const std::filesystem::path& folder);

/// Returns a feature whose buffer is a data URI, to be changed and written again.
nlohmann::json editable_document();

/// Returns the bytes of that buffer.
std::vector<char> editable_buffer();

/// Returns why a file is refused, or an empty text.
std::string message_of(const std::filesystem::path& path, bool strict = false);

/// Imports a file, which must import. Returns an empty one and records a failure if it does not.
anim::ImportedFile import_good(const std::filesystem::path& path);

/// Returns a test's name for a file. It holds only letters and digits, because a test's name may not hold others.
std::string as_test_name(const std::string& file);

/// A folder of its own, with files that the test makes.
class TemporaryFolder {
 public:
  /// Writes a file there and returns its path.
  std::filesystem::path write(const std::string& name, const std::vector<char>& bytes) const;
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  test::OwnFolder folder_;
};

}  // namespace throng::import::testing
