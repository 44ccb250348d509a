#include "tests/fuzz/scratch_file.h"

#include <cstdlib>
#include <fstream>
#include <system_error>

namespace throng::fuzz {

ScratchFile::ScratchFile(std::string_view name) {
  std::string pattern = (std::filesystem::temp_directory_path() / "throng-fuzz-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) std::abort();
  file_ = std::filesystem::path(pattern) / name;
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  std::filesystem::remove_all(file_.parent_path(), ignored);
}

void ScratchFile::put(std::span<const std::byte> bytes) const {
  std::ofstream stream(file_, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) std::abort();  // a full disk is no finding, but nothing would be tried
}

}  // namespace throng::fuzz
