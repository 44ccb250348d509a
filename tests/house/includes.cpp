#include "tests/house/includes.h"

#include <filesystem>
#include <regex>
#include <set>

namespace throng::house {
namespace {

/// Returns the path of a header in the tree. Public headers have a folder in the library that implements them.
std::string in_tree(const std::string& included) {
  if (!included.starts_with("throng/")) return included;
  static const std::set<std::string> of_crowd{"throng/crowd_view.h", "throng/heading.h", "throng/heap_pages.h",
                                              "throng/drawing.h", "throng/view_rules.h"};
  if (of_crowd.contains(included)) return "engine/crowd/include/" + included;
  return (included.starts_with("throng/render/") ? "engine/render/include/" : "engine/anim/include/") + included;
}

}  // namespace

bool is_code(const std::string& path) {
  static const std::set<std::string> code{".h", ".cpp", ".c", ".glsl", ".vert", ".frag", ".comp"};
  return code.contains(std::filesystem::path(path).extension().string());
}

std::vector<Include> includes_of(const Tree& tree, std::string_view folder) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
  std::vector<Include> includes;
  for (const SourceFile& file : tree) {
    if (!file.path.starts_with(folder) || !is_code(file.path)) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      std::smatch match;
      if (std::regex_match(file.lines[i], match, pattern)) includes.push_back({&file, i + 1, in_tree(match[1])});
    }
  }
  return includes;
}

std::map<std::string, std::size_t> own_headers_behind(const Tree& tree) {
  std::map<std::string, std::vector<std::string>> included_by;  // of files of ours
  for (const SourceFile& file : tree) included_by[file.path];
  for (const std::string_view folder : {"engine/", "app/"}) {
    for (const Include& include : includes_of(tree, folder)) {
      if (included_by.contains(include.target)) included_by[include.file->path].push_back(include.target);
    }
  }
  std::map<std::string, std::size_t> counts;
  for (const auto& [path, direct] : included_by) {
    if (!path.starts_with("app/") || !path.ends_with(".cpp")) continue;
    std::set<std::string> seen(direct.begin(), direct.end());
    std::vector<std::string> next(seen.begin(), seen.end());
    while (!next.empty()) {
      const std::string file = next.back();
      next.pop_back();
      for (const std::string& target : included_by[file]) {
        if (seen.insert(target).second) next.push_back(target);
      }
    }
    counts[path] = seen.size();
  }
  return counts;
}

}  // namespace throng::house
