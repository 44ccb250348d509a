#include "engine/anim/pack/mapped_file.h"

#if !defined(_WIN32)  // mapped_file_windows.cpp is for Windows

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace throng::pack {
namespace {

class OpenFile {
 public:
  explicit OpenFile(const std::string& path) : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

anim::Error failure() { return {std::strerror(errno)}; }

#if defined(MAP_POPULATE)
constexpr int map_at_once = MAP_POPULATE;  // all of it is read to be checked
#else
constexpr int map_at_once = 0;
#endif

}  // namespace

anim::Result<MappedFile> map_file(const std::string& path) {
  const OpenFile file(path);
  if (file.descriptor() < 0) return failure();
  struct stat status {};
  if (fstat(file.descriptor(), &status) != 0) return failure();
  if (!S_ISREG(status.st_mode)) return anim::Error{"it is no plain file"};
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0) return MappedFile{};  // nothing can be mapped
  void* const start = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | map_at_once, file.descriptor(), 0);
  if (start == MAP_FAILED) return failure();
  return MappedFile{.bytes = {static_cast<const std::byte*>(start), size},
                    .owner = {start, [size](void* mapped) { munmap(mapped, size); }}};
}

}  // namespace throng::pack

#endif  // !_WIN32
