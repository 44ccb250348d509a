#include "app/files/program_words.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <string_view>

namespace throng::app {
namespace {

bool is_plain(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || std::strchr("-_=./,:+@%", letter) != nullptr;
}

}  // namespace

std::string last_line(const std::string& text) {
  std::string_view left = text;
  while (!left.empty()) {
    const std::size_t end = left.find_last_of("\r\n");
    const std::string_view line = end == std::string_view::npos ? left : left.substr(end + 1);
    if (line.find_first_not_of(" \t") != std::string_view::npos) return std::string(line);
    left = end == std::string_view::npos ? std::string_view() : left.substr(0, end);
  }
  return {};
}

std::string as_typed(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "" : " ";
    if (!word.empty() && std::ranges::all_of(word, is_plain)) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char letter : word) line += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    line += '\'';
  }
  return line;
}

}  // namespace throng::app
