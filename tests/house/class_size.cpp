#include "tests/house/class_size.h"

#include <algorithm>
#include <functional>
#include <regex>
#include <string>

#include "tests/house/declarations.h"

namespace throng::house {
namespace {

/// Counts the methods of a class. A friend function is public wherever it stands.
ClassSize size_of(const ClassBody& one, const std::string& path) {
  ClassSize size;
  size.name = path + ":" + std::to_string(one.line) + ": " + one.name;
  for_each_declaration(one.body, one.is_struct, [&](const std::string& head, bool is_public) {
    if (declares_a_method(head)) ++(is_public || is_friend(head) ? size.public_methods : size.private_methods);
  });
  return size;
}

}  // namespace

std::vector<ClassSize> class_sizes(const Tree& tree) {
  std::vector<ClassSize> sizes;
  for (const SourceFile& file : tree) {
    const bool is_ours = file.path.starts_with("engine/") || file.path.starts_with("app/");
    if (!is_ours || !file.path.ends_with(".h")) continue;
    for (const ClassBody& one : class_bodies(code_of(file))) sizes.push_back(size_of(one, file.path));
  }
  std::ranges::stable_sort(sizes, std::ranges::greater(), &ClassSize::public_methods);
  return sizes;
}

Findings classes_with_too_many_methods(const Tree& tree) {
  Findings findings;
  for (const ClassSize& size : class_sizes(tree)) {
    if (size.public_methods <= most_public_methods) break;
    findings.push_back(size.name + " has " + std::to_string(size.public_methods) +
                       " public methods: which parts are inside?");
  }
  return findings;
}

Findings friends_that_are_methods(const Tree& tree) {
  static const std::regex friends(R"(\bfriend\s+(?!class\b|struct\b)[^;{]*)");
  Findings findings;
  for (const SourceFile& file : tree) {
    if (!file.path.starts_with("app/") || !(file.path.ends_with(".h") || file.path.ends_with(".cpp"))) continue;
    const std::string code = code_of(file);
    for (std::sregex_iterator match(code.begin(), code.end(), friends), end; match != end; ++match) {
      if (match->str().find("operator") != std::string::npos) continue;
      const auto line = std::count(code.begin(), code.begin() + match->position(), '\n') + 1;
      findings.push_back(file.path + ":" + std::to_string(line) + ": a method in hiding: " + match->str());
    }
  }
  return findings;
}

}  // namespace throng::house
