#include "engine/base/files/input_file.h"

#if !defined(_WIN32)  // input_file_windows.cpp is for Windows

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace throng {
namespace {

/// Keeps a descriptor, which is no pointer, where a handle is expected.
struct Descriptor {
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(number); }
  int number;
};

int number_of(const std::shared_ptr<void>& handle) { return static_cast<const Descriptor*>(handle.get())->number; }

Error failure(std::string_view what) {
  const int number = errno;
  return {"it cannot be " + std::string(what) + ": " + std::generic_category().message(number)};
}

Error failed_to_open(const std::filesystem::path& path) {
  if (errno != ENOENT && errno != ENOTDIR) return failure("read");
  std::error_code error;
  const std::filesystem::path target = std::filesystem::read_symlink(path, error);
  if (!error) return {"it is a link to " + target.string() + ", which does not exist"};
  return {"there is no such file; check the path"};
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "folder";
  if (S_ISFIFO(mode)) return "pipe";
  if (S_ISSOCK(mode)) return "socket";
  return "device";
}

#if defined(MAP_POPULATE)
constexpr int map_at_once = MAP_POPULATE;  // all of it is read to be checked
#else
constexpr int map_at_once = 0;
#endif

}  // namespace

Result<InputFile> InputFile::open(const std::filesystem::path& path, std::string_view wanted) {
  const auto refused = [&](mode_t mode) {
    return Error{std::string("it is a ") + kind_of(mode) + ", not a file; name " + std::string(wanted)};
  };
  // A device may do something when it is opened, so it is looked at before.
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return failed_to_open(path);
  if (!S_ISREG(status.st_mode)) return refused(status.st_mode);
  const int number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (number < 0) return failed_to_open(path);
  std::shared_ptr<void> handle = std::make_shared<Descriptor>(number);
  if (fstat(number, &status) != 0) return failure("read");
  if (!S_ISREG(status.st_mode)) return refused(status.st_mode);
  return unless_pointer(InputFile(std::move(handle), static_cast<std::uint64_t>(status.st_size)));
}

Result<std::size_t> InputFile::read(std::span<std::byte> bytes) {
  std::size_t count = 0;
  while (count < bytes.size()) {
    const ssize_t more = ::read(number_of(handle_), bytes.data() + count, bytes.size() - count);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) return failure("read");
    if (more == 0) break;
    count += static_cast<std::size_t>(more);
  }
  return count;
}

Status InputFile::go_to(std::uint64_t byte) {
  if (lseek(number_of(handle_), static_cast<off_t>(byte), SEEK_SET) < 0) return failure("read");
  return Done{};
}

Result<MappedFile> InputFile::map() const {
  const auto size = static_cast<std::size_t>(size_);
  if (size == 0) return MappedFile{};  // nothing can be mapped
  void* const start = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | map_at_once, number_of(handle_), 0);
  if (start == MAP_FAILED) return failure("mapped into memory");
  return MappedFile{.bytes = {static_cast<const std::byte*>(start), size},
                    .owner = {start, [size](void* mapped) { munmap(mapped, size); }}};
}

}  // namespace throng

#endif  // !_WIN32
