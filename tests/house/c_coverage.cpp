#include "tests/house/c_coverage.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <set>

#include "tests/house/declarations.h"

namespace throng::house {
namespace {

constexpr std::string_view public_headers = "engine/anim/include/throng/";

/// Returns the name of the function that `head` declares; nothing for what is no function with a name.
std::optional<std::string> function_name(const std::string& head) {
  static const std::regex named(R"([^(=]*?(~?\w+)\s*\((?!\s*\*)[^]*)");
  const std::string plain = without_template_arguments(head);
  std::smatch match;
  if (!declares_a_method(head) || plain.find("operator") != std::string::npos) return {};
  return std::regex_match(plain, match, named) ? std::optional(match.str(1)) : std::nullopt;
}

/// Returns the code of a header, in which a result `class Name` of a function is `Name`.
std::string plain_code_of(const SourceFile& header) {
  static const std::regex forward(R"(\bclass (\w+ \w+\())");
  return std::regex_replace(code_of(header), forward, "$1");
}

void add_methods(const std::string& code, std::set<std::string>& functions) {
  for (const ClassBody& one : class_bodies(code)) {
    for_each_declaration(one.body, one.is_struct, [&](const std::string& head, bool is_public) {
      const auto name = function_name(head);
      if (is_public && name && *name != one.name && *name != "~" + one.name && one.name != "std") {
        functions.insert(one.name + "::" + *name);
      }
    });
  }
}

void add_free_functions(const std::string& code, std::set<std::string>& functions) {
  static const std::regex beginning(R"(\bnamespace throng \{)");
  for (std::sregex_iterator match(code.begin(), code.end(), beginning), end; match != end; ++match) {
    const auto open = static_cast<std::size_t>(match->position() + match->length()) - 1;
    const std::size_t close = after_braces(code, open) - 1;
    for_each_declaration(std::string_view(code).substr(open + 1, close - open - 1), true,
                         [&](const std::string& head, bool) {
                           if (const auto name = function_name(head)) functions.insert(*name);
                         });
  }
}

void add_functions_of_c(const std::string& code, std::set<std::string>& functions) {
  static const std::regex declaration(R"(\bTHRONG_C\s[^;(]*\b(throng_\w+)\()");
  for (std::sregex_iterator match(code.begin(), code.end(), declaration), end; match != end; ++match) {
    functions.insert(match->str(1));
  }
}

/// Finds what is wrong with a row, whose functions are among those of the headers.
void check_row(const CoverageRow& row, const std::set<std::string>& cpp, const std::set<std::string>& c,
               Findings& findings) {
  if (!row.cpp.empty() && !cpp.contains(row.cpp))
    findings.push_back(row.cpp + " is no function of the headers for C++");
  for (const std::string& one : row.c) {
    if (!c.contains(one)) findings.push_back(one + " is no function of the headers for C");
  }
  if ((row.cpp.empty() || row.c.empty()) && row.why.empty()) {
    findings.push_back((row.cpp.empty() ? row.c.front() : row.cpp) + " stands alone without a reason");
  }
}

std::string without_comments_of_c(std::string code) {
  for (std::size_t begin = code.find("/*"); begin != std::string::npos; begin = code.find("/*", begin)) {
    code.erase(begin, code.find("*/", begin) + 2 - begin);
  }
  return code;
}

/// Returns the member that `head` declares; nothing for what is none.
std::optional<std::string> member_name(const std::string& head) {
  static const std::regex pointer_to_function(R"([^(=]*\(\*(\w+)\)\([^]*)");
  static const std::regex other(R"(^\s*(using|friend|static_assert|enum|class|struct|static)\b[^]*)");
  static const std::regex named(R"([^=\[]*?(\w+)\s*([=\[][^]*)?)");
  std::smatch match;
  if (std::regex_match(head, match, pointer_to_function)) return match.str(1);
  const std::string plain = without_template_arguments(head);
  if (declares_a_method(head) || std::regex_match(plain, other)) return {};
  return std::regex_match(plain, match, named) ? std::optional(match.str(1)) : std::nullopt;
}

/// By the name of a struct of a public header, for C++ or C: the names of its members.
using Members = std::map<std::string, std::vector<std::string>>;

Members members_of(const Tree& tree) {
  Members members;
  for (const SourceFile& file : tree) {
    if (!file.path.starts_with(public_headers) || !file.path.ends_with(".h")) continue;
    for (const ClassBody& one : class_bodies(without_comments_of_c(code_of(file)))) {
      for_each_declaration(one.body, true, [&](const std::string& head, bool) {
        if (const auto name = member_name(head)) members[one.name].push_back(*name);
      });
    }
  }
  return members;
}

}  // namespace

Findings c_struct_gaps(const Tree& tree, const std::vector<CStructRow>& table) {
  const Members members = members_of(tree);
  Findings findings;
  for (const CStructRow& row : table) {
    const auto cpp = members.find(row.cpp), c = members.find(row.c);
    if (cpp == members.end()) findings.push_back(row.cpp + " is no struct of the headers for C++");
    if (c == members.end()) findings.push_back(row.c + " is no struct of the headers for C");
    if (cpp == members.end() || c == members.end()) continue;
    for (const std::string& member : cpp->second) {
      const auto renamed = row.renamed.find(member);
      const std::string& wanted = renamed == row.renamed.end() ? member : renamed->second;
      if (std::ranges::count(c->second, wanted) == 0) {
        findings.push_back(row.cpp + "::" + member + " has no member in " + row.c);
      }
    }
  }
  return findings;
}

Findings c_coverage_gaps(const Tree& tree, const std::vector<CoverageRow>& table) {
  std::set<std::string> cpp, c;
  for (const SourceFile& file : tree) {
    if (!file.path.starts_with(public_headers) || !file.path.ends_with(".h")) continue;
    const std::string code = plain_code_of(file);
    const std::string name = file.path.substr(public_headers.size());
    if (name.starts_with("c/")) add_functions_of_c(code, c);
    if (name.find('/') != std::string::npos || name == "c.h") continue;
    add_methods(code, cpp);
    add_free_functions(code, cpp);
  }
  Findings findings;
  std::set<std::string> in_a_row;
  for (const CoverageRow& row : table) {
    check_row(row, cpp, c, findings);
    in_a_row.insert(row.cpp);
    in_a_row.insert(row.c.begin(), row.c.end());
  }
  for (const std::set<std::string>* const functions : {&cpp, &c}) {
    for (const std::string& one : *functions) {
      if (!in_a_row.contains(one)) findings.push_back(one + " has no row in the table of C and C++");
    }
  }
  return findings;
}

}  // namespace throng::house
