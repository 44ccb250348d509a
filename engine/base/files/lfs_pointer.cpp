#include <array>
#include <cstring>

#include "engine/base/files/input_file.h"

namespace throng {

/// A clone without Git LFS has a text of some lines in place of each large file.
Result<InputFile> InputFile::unless_pointer(InputFile file) {
  constexpr std::string_view beginning = "version https://git-lfs.github.com/spec/";
  constexpr std::uint64_t longest = 1024;  // bytes, as its specification says
  if (file.size() < beginning.size() || file.size() >= longest) return file;
  std::array<std::byte, beginning.size()> bytes{};
  const auto count = file.read(bytes);
  if (!count) return count.error();
  if (*count == bytes.size() && std::memcmp(bytes.data(), beginning.data(), bytes.size()) == 0) {
    return Error{"it is a pointer of Git LFS, not the file itself; run git lfs pull"};
  }
  if (const Status back = file.go_to(0); !back) return back.error();
  return file;
}

}  // namespace throng
