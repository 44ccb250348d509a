#include "engine/base/files/folder_entries.h"

#include <algorithm>
#include <system_error>
#include <tuple>

#include "engine/base/text/plain_text.h"

namespace throng {
namespace fs = std::filesystem;

Result<std::vector<FolderEntry>> folder_entries(const fs::path& folder) {
  std::vector<FolderEntry> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code unreadable;
    const fs::file_status status = entry->status(unreadable);
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.') || !(fs::is_directory(status) || fs::is_regular_file(status))) continue;
    entries.push_back({.name = name, .is_folder = fs::is_directory(status)});
  }
  if (error) return Error{plain_text(folder.string()) + ": the folder cannot be read: " + error.message()};
  std::ranges::sort(entries, {}, [](const FolderEntry& each) { return std::tuple(!each.is_folder, each.name); });
  return entries;
}

}  // namespace throng
