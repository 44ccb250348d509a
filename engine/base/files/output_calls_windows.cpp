#if defined(_WIN32)

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

#include "engine/base/files/output_calls.h"

namespace throng::output_calls {

int open_new(const std::filesystem::path& file) {
  return _wopen(file.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

int open_straight(const std::filesystem::path& file) {
  return _wopen(file.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT);
}

std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t count) {
  constexpr std::size_t most_at_once = std::size_t{1} << 30U;
  return _write(descriptor, bytes, static_cast<unsigned>(std::min(count, most_at_once)));
}

int sync(int descriptor) { return _commit(descriptor); }

int close(int descriptor) { return _close(descriptor); }

void take_rights(int, const std::filesystem::path&) {}  // a new file has its folder's rights

int replace(const std::filesystem::path& part, const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::rename(part, file, error);
  if (!error) return 0;
  errno = error.default_error_condition().value();
  return -1;
}

std::span<const int> errors_of_a_full_disk() {
  static constexpr std::array<int, 1> numbers{ENOSPC};
  return numbers;
}

}  // namespace throng::output_calls

#endif  // _WIN32
