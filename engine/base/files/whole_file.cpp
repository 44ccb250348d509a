#include <algorithm>

#include "engine/base/files/input_file.h"
#include "engine/base/text/size_text.h"

namespace throng {
namespace {

/// Reads to the end. The size is a guess alone: a file may grow meanwhile, and files of /proc say 0.
template <typename Bytes>
Result<Bytes> read_all(const std::filesystem::path& path, std::string_view wanted, std::size_t most) {
  constexpr std::size_t piece = 65536;
  auto file = InputFile::open(path, wanted);
  if (!file) return file.error();
  const Error too_large{"it is larger than " + size_text(most) + ", the most for " + std::string(wanted)};
  if (file->size() > most) return too_large;
  Bytes bytes(static_cast<std::size_t>(file->size()) + 1, {});  // one more shows whether the file has more
  for (std::size_t count = 0;;) {
    const auto more = file->read(std::as_writable_bytes(std::span(bytes)).subspan(count));
    if (!more) return more.error();
    const std::size_t asked = bytes.size() - count;
    count += *more;
    if (*more < asked) {
      bytes.resize(count);
      return bytes;
    }
    if (count > most) return too_large;
    bytes.resize(std::min(count + piece, most + 1));
  }
}

}  // namespace

Result<std::vector<std::byte>> read_file(const std::filesystem::path& path, std::string_view wanted, std::size_t most) {
  return read_all<std::vector<std::byte>>(path, wanted, most);
}

Result<std::string> read_text(const std::filesystem::path& path, std::string_view wanted, std::size_t most) {
  return read_all<std::string>(path, wanted, most);
}

Result<MappedFile> map_file(const std::filesystem::path& path, std::string_view wanted) {
  const auto file = InputFile::open(path, wanted);
  return file ? file->map() : file.error();
}

}  // namespace throng
