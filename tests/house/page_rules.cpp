#include "tests/house/page_rules.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

namespace throng::house {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_lines_of_first_page = 180;
constexpr std::ptrdiff_t most_characters_of_first_page = 120;

/// By the path of a page: its headings, as links name them.
using Headings = std::map<std::string, std::set<std::string>>;

std::string line_finding(const SourceFile& file, std::size_t line, const std::string& what) {
  return file.path + ":" + std::to_string(line) + ": " + what;
}

std::ptrdiff_t characters(const std::string& utf8) {
  return std::ranges::count_if(utf8, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; });
}

/// "how-to-measure" for "## How to measure".
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char letter : heading.substr(heading.find(' ') + 1)) {
    const auto byte = static_cast<unsigned char>(letter);
    if (letter == ' ') anchor += '-';
    if (std::isalnum(byte) != 0 || letter == '-' || letter == '_') anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

/// Calls visit(line number, line) for each line of a page that is not inside a block of code.
void for_each_line_of_text(const SourceFile& page, auto visit) {
  bool is_code = false;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const bool is_fence = page.lines[i].starts_with("```");
    if (is_fence) is_code = !is_code;
    if (!is_fence && !is_code) visit(i + 1, page.lines[i]);
  }
}

bool is_markdown(const SourceFile& file) { return file.path.ends_with(".md"); }

Headings headings_of(const Tree& tree) {
  Headings headings;
  for (const SourceFile& page : tree) {
    if (!is_markdown(page)) continue;
    for_each_line_of_text(page, [&](std::size_t, const std::string& line) {
      if (line.starts_with('#')) headings[page.path].insert(anchor_of(line));
    });
  }
  return headings;
}

}  // namespace

Findings first_page_too_large(const Tree& tree) {
  Findings findings;
  for (const SourceFile& file : tree) {
    if (file.path != "README.md") continue;
    if (file.lines.size() > most_lines_of_first_page)
      findings.push_back(line_finding(file, file.lines.size(), "too long"));
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (characters(file.lines[i]) > most_characters_of_first_page) {
        findings.push_back(line_finding(file, i + 1, "the line is too long"));
      }
    }
  }
  return findings;
}

Findings links_that_lead_nowhere(const Tree& tree, const std::function<bool(const std::string&)>& exists) {
  static const std::regex link(R"(\]\(([^)\s]+)\)|^\[[^\]]+\]: +(\S+))");
  const Headings headings = headings_of(tree);
  Findings findings;
  for (const SourceFile& page : tree) {
    if (!is_markdown(page)) continue;
    for_each_line_of_text(page, [&](std::size_t number, const std::string& line) {
      for (std::sregex_iterator match(line.begin(), line.end(), link), end; match != end; ++match) {
        const std::string target = (*match)[1].matched ? (*match)[1] : (*match)[2];
        if (target.find("://") != std::string::npos) continue;
        const std::size_t hash = target.find('#');
        const fs::path path = fs::path(page.path).parent_path() / target.substr(0, hash);
        const std::string file = hash == 0 ? page.path : path.lexically_normal().generic_string();
        const auto there = headings.find(file);
        const bool leads = hash == std::string::npos
                               ? exists(file)
                               : there != headings.end() && there->second.contains(target.substr(hash + 1));
        if (!leads) findings.push_back(line_finding(page, number, "a link leads nowhere: " + target));
      }
    });
  }
  return findings;
}

Findings files_to_try_that_are_missing(const Tree& tree, const std::function<bool(const std::string&)>& exists) {
  static const std::regex named(R"([\w/.-]*[a-z]\.(glb|gltf|txt|wkt|sqlite|throng)\b)");
  Findings findings;
  for (const SourceFile& file : tree) {
    if (file.path != "README.md") continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      for (std::sregex_iterator match(line.begin(), line.end(), named), end; match != end; ++match) {
        if (!exists(match->str())) findings.push_back(line_finding(file, i + 1, "there is no " + match->str()));
      }
    }
  }
  return findings;
}

}  // namespace throng::house
