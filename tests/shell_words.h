#pragma once

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace throng::test {

/// Returns the words of a line as a shell takes them, but for the first, which is the program; none where the shell
/// refuses the line.
inline std::vector<std::string> words_for_the_program(const std::string& line) {
  std::vector<std::string> words;
  FILE* const shell = popen(("printf '%s\\0' " + line).c_str(), "r");
  if (shell == nullptr) return words;
  std::string word;
  for (int byte = std::fgetc(shell); byte != EOF; byte = std::fgetc(shell)) {
    if (byte != 0) {
      word += static_cast<char>(byte);
    } else {
      words.push_back(std::exchange(word, {}));
    }
  }
  if (pclose(shell) != 0 || words.empty()) return {};
  words.erase(words.begin());
  return words;
}

}  // namespace throng::test
