#include "app/files/data_folder.h"

#include <cstdlib>
#include <system_error>

namespace throng::app {
namespace {

namespace fs = std::filesystem;

/// The data folder of an installed program; empty if the system does not say where the program is.
fs::path share_folder() {
  const fs::path program = program_folder();
  return program.empty() ? program : (program / "../share/throng").lexically_normal();
}

fs::path environment_folder() {
  const char* const folder = std::getenv("THRONG_DATA");
  return folder == nullptr ? "" : folder;
}

}  // namespace

fs::path program_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

std::vector<fs::path> data_folders(const std::string& data_option) {
  std::vector<fs::path> folders;
  for (const fs::path& folder :
       {fs::path(data_option), environment_folder(), share_folder(), fs::path(THRONG_SOURCE_DIR)}) {
    if (!folder.empty()) folders.push_back(folder);
  }
  return folders;
}

Result<fs::path> find_data(const std::vector<fs::path>& folders, const fs::path& name) {
  std::string tried;
  for (const fs::path& folder : folders) {
    std::error_code error;
    if (fs::exists(folder / name, error)) return folder / name;
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  return Error{name.string() + ": not found in " + tried + "; --data DIR names the folder that has it"};
}

}  // namespace throng::app
