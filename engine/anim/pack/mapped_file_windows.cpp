#if defined(_WIN32)

#include <filesystem>
#include <memory>
#include <system_error>

#include <windows.h>

#include "engine/anim/pack/mapped_file.h"

namespace throng::pack {
namespace {

struct CloseHandleOf {
  void operator()(void* handle) const { CloseHandle(handle); }
};
using OpenHandle = std::unique_ptr<void, CloseHandleOf>;

anim::Error failure() { return {std::system_category().message(static_cast<int>(GetLastError()))}; }

}  // namespace

anim::Result<MappedFile> map_file(const std::string& path) {
  const std::u8string utf8(path.begin(), path.end());
  HANDLE const opened =
      CreateFileW(std::filesystem::path(utf8).c_str(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                  OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (opened == INVALID_HANDLE_VALUE) return failure();
  const OpenHandle file(opened);
  if (GetFileType(file.get()) != FILE_TYPE_DISK) return anim::Error{"it is no plain file"};
  LARGE_INTEGER size{};
  if (GetFileSizeEx(file.get(), &size) == 0) return failure();
  if (size.QuadPart == 0) return MappedFile{};  // nothing can be mapped
  const OpenHandle mapping(CreateFileMappingW(file.get(), nullptr, PAGE_READONLY, 0, 0, nullptr));
  if (mapping == nullptr) return failure();
  const void* const start = MapViewOfFile(mapping.get(), FILE_MAP_READ, 0, 0, 0);
  if (start == nullptr) return failure();
  return MappedFile{.bytes = {static_cast<const std::byte*>(start), static_cast<std::size_t>(size.QuadPart)},
                    .owner = {start, [](const void* mapped) { UnmapViewOfFile(mapped); }}};
}

}  // namespace throng::pack

#endif  // _WIN32
