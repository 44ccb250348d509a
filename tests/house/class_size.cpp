#include "tests/house/class_size.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <string>
#include <string_view>

namespace throng::house {
namespace {

/// The text of a header with spaces in place of comments, strings and lines of the preprocessor.
std::string code_of(const SourceFile& file) {
  static const std::regex unread(R"(//.*|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)'|^\s*#.*)");
  std::string code;
  for (const std::string& line : file.lines) code += std::regex_replace(line, unread, " ") + '\n';
  return code;
}

/// The place after the brace that closes the one at `open`.
std::size_t after_braces(std::string_view code, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < code.size(); ++i) {
    if (code[i] == '{') ++depth;
    if (code[i] == '}' && --depth == 0) return i + 1;
  }
  return code.size();
}

std::string without_template_arguments(std::string text) {
  static const std::regex innermost(R"(<[^<>]*>)");
  for (std::string before; before != text;) {
    before = text;
    text = std::regex_replace(text, innermost, " ");
  }
  return text;
}

/// `head`: a declaration up to its body, its initialiser or its semicolon.
bool declares_a_method(const std::string& head) {
  static const std::regex other(R"(^\s*(using|typedef|friend|static_assert|enum|class|struct|union)\b[^]*)");
  static const std::regex deleted(R"([^]*=\s*delete\s*$)");
  static const std::regex templated(R"(^\s*template\s*)");
  const bool is_operator = head.find("operator") != std::string::npos;
  const std::string plain = std::regex_replace(without_template_arguments(head), templated, "");
  if (std::regex_match(plain, other) || std::regex_match(plain, deleted)) return false;
  return is_operator || plain.substr(0, plain.find('=')).find('(') != std::string::npos;
}

/// True: the brace after `head` begins a member's value in the list of a constructor, not the constructor's body.
bool is_in_initialiser_list(const std::string& head) {
  static const std::regex list(R"([^]*\)\s*(noexcept)?\s*:[^:][^]*[\w>]\s*$)");
  return std::regex_match(head, list);
}

/// `body`: what stands between the braces of a class.
int public_methods(std::string_view body, bool is_public) {
  static const std::regex label(R"(^\s*(public|protected|private)\s*$)");
  int methods = 0;
  std::string head;
  for (std::size_t i = 0; i < body.size();) {
    const bool ends_label = body[i] == ':' && std::regex_match(head, label);
    if (ends_label) {
      is_public = head.find("public") != std::string::npos;
      head.clear();
      ++i;
    } else if (body[i] == '{') {
      i = after_braces(body, i);
      if (is_in_initialiser_list(head)) {
        head += "()";
        continue;
      }
      if (is_public && declares_a_method(head)) ++methods;
      const bool has_body = declares_a_method(head);
      head = has_body ? "" : "static_assert ";  // until its semicolon, which a class or a value still has
    } else if (body[i] == ';') {
      if (is_public && declares_a_method(head)) ++methods;
      head.clear();
      ++i;
    } else {
      head += body[i++];
    }
  }
  return methods;
}

}  // namespace

Findings classes_with_too_many_methods(const Tree& tree) {
  static const std::regex beginning(R"((enum\s+)?\b(class|struct)\s+(\w+)(\s+final)?\s*(:[^;{}()]*)?\{)");
  Findings findings;
  for (const SourceFile& file : tree) {
    const bool is_ours = file.path.starts_with("engine/") || file.path.starts_with("app/");
    if (!is_ours || !file.path.ends_with(".h")) continue;
    const std::string code = code_of(file);
    for (std::sregex_iterator match(code.begin(), code.end(), beginning), end; match != end; ++match) {
      if ((*match)[1].matched) continue;
      const auto open = static_cast<std::size_t>(match->position() + match->length()) - 1;
      const std::size_t close = after_braces(code, open) - 1;
      const int methods =
          public_methods(std::string_view(code).substr(open + 1, close - open - 1), (*match)[2] == "struct");
      if (methods <= most_public_methods) continue;
      const auto line = std::count(code.begin(), code.begin() + match->position(), '\n') + 1;
      findings.push_back(file.path + ":" + std::to_string(line) + ": " + match->str(3) + " has " +
                         std::to_string(methods) + " public methods: which parts are inside?");
    }
  }
  return findings;
}

}  // namespace throng::house
