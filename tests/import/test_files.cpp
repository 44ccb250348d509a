#include "tests/import/test_files.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "engine/anim/import/bytes/data_uri.h"
#include "engine/anim/import/import.h"

namespace throng::import::testing {

std::filesystem::path data_path(const std::string& name) {
  return std::filesystem::path(THRONG_SOURCE_DIR) / "tests/data" / name;
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return nlohmann::json::parse(stream);
}

std::vector<char> read_bytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> model_files(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".glb" || extension == ".gltf") files.push_back(entry.path().filename().string());
  }
  std::ranges::sort(files);
  return files;
}

nlohmann::json editable_document() { return read_json(data_path("features/data-uri.gltf")); }

std::vector<char> editable_buffer() {
  const std::string uri = editable_document()["buffers"][0]["uri"];
  const std::vector<std::byte> bytes = decode_data_uri(uri);
  const auto* from = reinterpret_cast<const char*>(bytes.data());
  return {from, from + bytes.size()};
}

std::string message_of(const std::filesystem::path& path, bool strict) {
  const auto file = import_file(path.string(), {.strict = strict});
  return file ? "" : file.error().message;
}

anim::ImportedFile import_good(const std::filesystem::path& path) {
  auto file = import_file(path.string());
  if (file) return std::move(*file);
  ADD_FAILURE() << file.error().message;
  return {};
}

std::string as_test_name(const std::string& file) {
  std::string name = file;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

std::filesystem::path TemporaryFolder::write(const std::string& name, const std::vector<char>& bytes) const {
  const auto file = folder_.path() / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

std::filesystem::path TemporaryFolder::write(const std::string& name, const std::string& text) const {
  return write(name, std::vector<char>(text.begin(), text.end()));
}

}  // namespace throng::import::testing
