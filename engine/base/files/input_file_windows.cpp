#if defined(_WIN32)

#include <algorithm>
#include <system_error>

#include <windows.h>

#include "engine/base/files/input_file.h"

namespace throng {
namespace {

Error failure(std::string_view what) {
  return {"it cannot be " + std::string(what) + ": " +
          std::system_category().message(static_cast<int>(GetLastError()))};
}

}  // namespace

Result<InputFile> InputFile::open(const std::filesystem::path& path, std::string_view wanted) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return Error{"there is no such file; check the path"};
  if (std::filesystem::is_directory(status)) {
    return Error{"it is a folder, not a file; name " + std::string(wanted)};
  }
  HANDLE const opened = CreateFileW(path.c_str(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                                    OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (opened == INVALID_HANDLE_VALUE) return failure("read");
  std::shared_ptr<void> handle(opened, CloseHandle);
  if (GetFileType(opened) != FILE_TYPE_DISK) {
    return Error{"it is a pipe or device, not a file; name " + std::string(wanted)};
  }
  LARGE_INTEGER size{};
  if (GetFileSizeEx(opened, &size) == 0) return failure("read");
  return unless_pointer(InputFile(std::move(handle), static_cast<std::uint64_t>(size.QuadPart)));
}

Result<std::size_t> InputFile::read(std::span<std::byte> bytes) {
  constexpr std::size_t most_at_once = std::size_t{1} << 30U;
  std::size_t count = 0;
  while (count < bytes.size()) {
    const auto wanted = static_cast<DWORD>(std::min(bytes.size() - count, most_at_once));
    DWORD more = 0;
    if (ReadFile(handle_.get(), bytes.data() + count, wanted, &more, nullptr) == 0) return failure("read");
    if (more == 0) break;
    count += more;
  }
  return count;
}

Status InputFile::go_to(std::uint64_t byte) {
  LARGE_INTEGER place{};
  place.QuadPart = static_cast<LONGLONG>(byte);
  if (SetFilePointerEx(handle_.get(), place, nullptr, FILE_BEGIN) == 0) return failure("read");
  return Done{};
}

Result<MappedFile> InputFile::map() const {
  if (size_ == 0) return MappedFile{};  // nothing can be mapped
  HANDLE const opened = CreateFileMappingW(handle_.get(), nullptr, PAGE_READONLY, 0, 0, nullptr);
  if (opened == nullptr) return failure("mapped into memory");
  const std::shared_ptr<void> mapping(opened, CloseHandle);
  const void* const start = MapViewOfFile(opened, FILE_MAP_READ, 0, 0, 0);
  if (start == nullptr) return failure("mapped into memory");
  return MappedFile{.bytes = {static_cast<const std::byte*>(start), static_cast<std::size_t>(size_)},
                    .owner = {start, [](const void* mapped) { UnmapViewOfFile(mapped); }}};
}

}  // namespace throng

#endif  // _WIN32
