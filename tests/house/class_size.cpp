#include "tests/house/class_size.h"

#include <algorithm>
#include <functional>
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

bool is_friend(const std::string& head) {
  static const std::regex pattern(R"(^\s*friend\b[^]*)");
  return std::regex_match(head, pattern);
}

/// `head`: a declaration up to its body, its initialiser or its semicolon. A friend function is a method too, but for
/// operators.
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

/// True: the brace after `head` begins a member's value in the list of a constructor, not the constructor's body.
bool is_in_initialiser_list(const std::string& head) {
  static const std::regex list(R"([^]*\)\s*(noexcept)?\s*:[^:][^]*[\w>]\s*$)");
  return std::regex_match(head, list);
}

/// `body`: what stands between the braces of a class. A friend function is public wherever it stands.
void count_methods(std::string_view body, bool is_public, ClassSize& size) {
  static const std::regex label(R"(^\s*(public|protected|private)\s*$)");
  const auto count = [&](const std::string& head) {
    if (declares_a_method(head)) ++(is_public || is_friend(head) ? size.public_methods : size.private_methods);
  };
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
      count(head);
      const bool has_body = declares_a_method(head) || is_friend(head);
      head = has_body ? "" : "static_assert ";  // until its semicolon, which a class or a value still has
    } else if (body[i] == ';') {
      count(head);
      head.clear();
      ++i;
    } else {
      head += body[i++];
    }
  }
}

}  // namespace

std::vector<ClassSize> class_sizes(const Tree& tree) {
  static const std::regex beginning(R"((enum\s+)?\b(class|struct)\s+(\w+)(\s+final)?\s*(:[^;{}()]*)?\{)");
  std::vector<ClassSize> sizes;
  for (const SourceFile& file : tree) {
    const bool is_ours = file.path.starts_with("engine/") || file.path.starts_with("app/");
    if (!is_ours || !file.path.ends_with(".h")) continue;
    const std::string code = code_of(file);
    for (std::sregex_iterator match(code.begin(), code.end(), beginning), end; match != end; ++match) {
      if ((*match)[1].matched) continue;
      const auto open = static_cast<std::size_t>(match->position() + match->length()) - 1;
      const std::size_t close = after_braces(code, open) - 1;
      const auto line = std::count(code.begin(), code.begin() + match->position(), '\n') + 1;
      ClassSize& size = sizes.emplace_back();
      size.name = file.path + ":" + std::to_string(line) + ": " + match->str(3);
      count_methods(std::string_view(code).substr(open + 1, close - open - 1), (*match)[2] == "struct", size);
    }
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
