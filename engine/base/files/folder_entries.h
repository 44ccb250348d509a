#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace throng {

/// A file or a folder in a folder.
struct FolderEntry {
  std::string name;
  bool is_folder = false;
};

/// Returns what lies in a folder, folders first, each by name. Links count as what they lead to. Hidden files, dead
/// links and what is neither file nor folder are left out. Errors: it is no folder, or it may not be read.
Result<std::vector<FolderEntry>> folder_entries(const std::filesystem::path& folder);

}  // namespace throng
