#include "app/commands/check/git.h"

#include <map>

#include "engine/base/files/child_process.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Returns the names in "XY NAME" lines.
std::vector<std::string> names_in(const std::string& status) {
  constexpr std::size_t letters_before = 3;
  std::vector<std::string> names;
  for (std::size_t from = 0; from < status.size();) {
    const std::size_t end = std::min(status.find('\n', from), status.size());
    if (end > from + letters_before) names.push_back(status.substr(from + letters_before, end - from - letters_before));
    from = end + 1;
  }
  return names;
}

std::optional<std::string> uncommitted_in(const fs::path& folder, const std::vector<std::string>& names) {
  std::vector<std::string> words{"git",
                                 "--literal-pathspecs",
                                 "-C",
                                 folder.string(),
                                 "status",
                                 "--porcelain",
                                 "--untracked-files=all",
                                 "--ignored",
                                 "--"};
  words.insert(words.end(), names.begin(), names.end());
  const auto ended = run_child(words);
  if (!ended) return "git is not installed, so nothing can bring back what is replaced in " + folder.string();
  if (ended->status != 0) {
    const std::string why = ended->errors.empty() ? "" : " (" + first_line(ended->errors) + ")";
    return "git cannot bring back what is replaced in " + folder.string() + why;
  }
  const std::vector<std::string> changed = names_in(ended->output);
  if (changed.empty()) return {};
  return folder.string() + " has uncommitted changes: " + joined(changed) + "; commit them first";
}

}  // namespace

std::optional<std::string> missing_in_git(const std::vector<fs::path>& files) {
  std::map<fs::path, std::vector<std::string>> by_folder;
  for (const fs::path& file : files) {
    std::error_code error;
    if (fs::exists(file, error)) by_folder[file.parent_path()].push_back(file.filename().string());
  }
  for (const auto& [folder, names] : by_folder) {
    if (auto why = uncommitted_in(folder, names)) return why;
  }
  return {};
}

}  // namespace throng::app
