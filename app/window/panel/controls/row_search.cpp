#include "app/window/panel/controls/row_search.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace throng::app {

bool has_letters(std::string_view text, std::string_view letters) {
  const auto equal = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return letters.empty() || std::search(text.begin(), text.end(), letters.begin(), letters.end(), equal) != text.end();
}

RowSearch::RowSearch(std::string_view text) {
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) words_.push_back(word);
}

void RowSearch::begin_tab(const char* name) {
  now_ = {.tab = name, .section = ""};
  is_new_ = true;
}

void RowSearch::begin_section(const char* title) {
  now_.section = title;
  is_new_ = true;
}

bool RowSearch::finds(std::string_view label, std::string_view what, std::string_view key) {
  const auto in_name = [&](const std::string& word) { return has_letters(label, word) || has_letters(key, word); };
  const auto anywhere = [&](const std::string& word) {
    return in_name(word) || has_letters(what, word) || has_letters(now_.section, word);
  };
  const bool by_name = std::ranges::all_of(words_, in_name);
  const bool found = pass_ == Pass::names ? by_name : !by_name && std::ranges::all_of(words_, anywhere);
  if (!found) return false;
  ++found_;
  last_ = now_;
  return true;
}

std::optional<RowSearch::Place> RowSearch::take_new_place() {
  if (!is_new_) return std::nullopt;
  is_new_ = false;
  return now_;
}

}  // namespace throng::app
