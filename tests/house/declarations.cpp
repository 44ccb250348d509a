#include "tests/house/declarations.h"

#include <algorithm>
#include <regex>

namespace throng::house {
namespace {

bool is_namespace(const std::string& head) {
  static const std::regex pattern(R"(^\s*namespace\b[^]*)");
  return std::regex_match(head, pattern);
}

/// True: the brace after `head` begins a member's value in the list of a constructor, not the constructor's body.
bool is_in_initialiser_list(const std::string& head) {
  static const std::regex list(R"([^]*\)\s*(noexcept)?\s*:[^:][^]*[\w>]\s*$)");
  return std::regex_match(head, list);
}

}  // namespace

std::string code_of(const SourceFile& file) {
  static const std::regex unread(R"(//.*|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)'|^\s*#.*)");
  std::string code;
  for (const std::string& line : file.lines) code += std::regex_replace(line, unread, " ") + '\n';
  return code;
}

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

bool is_friend(const std::string& head) {
  static const std::regex pattern(R"(^\s*friend\b[^]*)");
  return std::regex_match(head, pattern);
}

bool declares_a_method(const std::string& head) {
  static const std::regex other(
      R"(^\s*(using|typedef|friend\s+(class|struct)|static_assert|enum|class|struct|union)\b[^]*)");
  static const std::regex deleted(R"([^]*=\s*delete\s*$)");
  static const std::regex templated(R"(^\s*template\s*)");
  const bool is_operator = head.find("operator") != std::string::npos;
  if (is_operator && is_friend(head)) return false;
  const std::string plain = std::regex_replace(without_template_arguments(head), templated, "");
  if (std::regex_match(plain, other) || std::regex_match(plain, deleted)) return false;
  return is_operator || plain.substr(0, plain.find('=')).find('(') != std::string::npos;
}

void for_each_declaration(std::string_view body, bool is_public,
                          const std::function<void(const std::string& head, bool is_public)>& visit) {
  static const std::regex label(R"(^\s*(public|protected|private)\s*$)");
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
      visit(head, is_public);
      const bool has_body = declares_a_method(head) || is_friend(head) || is_namespace(head);
      head = has_body ? "" : "static_assert ";  // until its semicolon, which a class or a value still has
    } else if (body[i] == ';') {
      visit(head, is_public);
      head.clear();
      ++i;
    } else {
      head += body[i++];
    }
  }
}

std::vector<ClassBody> class_bodies(const std::string& code) {
  static const std::regex beginning(R"((enum\s+)?\b(class|struct)\s+(\w+)(\s+final)?\s*(:[^;{}()]*)?\{)");
  std::vector<ClassBody> classes;
  for (std::sregex_iterator match(code.begin(), code.end(), beginning), end; match != end; ++match) {
    if ((*match)[1].matched) continue;
    const auto open = static_cast<std::size_t>(match->position() + match->length()) - 1;
    const std::size_t close = after_braces(code, open) - 1;
    classes.push_back({.name = match->str(3),
                       .line = std::count(code.begin(), code.begin() + match->position(), '\n') + 1,
                       .is_struct = (*match)[2] == "struct",
                       .body = code.substr(open + 1, close - open - 1)});
  }
  return classes;
}

}  // namespace throng::house
