#include "engine/base/files/output_calls.h"

#if !defined(_WIN32)  // output_calls_windows.cpp is for Windows

#include <array>
#include <cstdio>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace throng::output_calls {

int open_new(const std::filesystem::path& file) {
  return ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

// A pipe without a reader would wait for one.
int open_straight(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor >= 0) fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return descriptor;
}

std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t count) { return ::write(descriptor, bytes, count); }

int sync(int descriptor) { return fsync(descriptor); }

int close(int descriptor) { return ::close(descriptor); }

void take_rights(int descriptor, const std::filesystem::path& from) {
  struct stat old {};
  if (stat(from.c_str(), &old) != 0) return;
  constexpr mode_t permissions = 07777;
  if (fchown(descriptor, old.st_uid, old.st_gid) == 0 || old.st_uid == geteuid()) {
    fchmod(descriptor, old.st_mode & permissions);
  }
}

int replace(const std::filesystem::path& part, const std::filesystem::path& file) {
  return std::rename(part.c_str(), file.c_str());
}

std::span<const int> errors_of_a_full_disk() {
  static constexpr std::array<int, 2> numbers{ENOSPC, EDQUOT};
  return numbers;
}

}  // namespace throng::output_calls

#endif  // !_WIN32
