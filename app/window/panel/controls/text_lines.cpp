#include "app/window/panel/controls/text_lines.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace throng::app {
namespace {

bool begins_a_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

/// Returns how many bytes of a text fit into a width, without a part of a letter.
std::size_t bytes_that_fit(const TextWidth& width_of, float width, std::string_view text) {
  std::size_t fits = 0;
  for (std::size_t end = 1; end <= text.size(); ++end) {
    if (end < text.size() && !begins_a_letter(text[end])) continue;
    if (width_of(text.substr(0, end)) > width) break;
    fits = end;
  }
  return fits;
}

/// Returns how many bytes of a word that is longer than a line stay in the line.
std::size_t end_in_word(const TextWidth& width_of, float width, std::string_view word) {
  const std::size_t fits = bytes_that_fit(width_of, width, word);
  const std::size_t slash = word.substr(0, fits).find_last_of("/\\");
  if (slash != std::string_view::npos && slash > 0) return slash + 1;
  std::size_t letter = 1;
  while (letter < word.size() && !begins_a_letter(word[letter])) ++letter;
  return std::max(fits, letter);
}

/// Puts words behind each other, and begins a line where the next word has no room.
class BrokenLines {
 public:
  BrokenLines(const TextWidth& width_of, float width) : width_of_(width_of), width_(width), blank_(width_of(" ")) {}

  void add(std::string_view word) {
    if (!is_empty_ && at_ + blank_ + width_of_(word) > width_) begin_line();
    if (!is_empty_) put(" ");
    while (is_empty_ && word.size() > 1 && width_of_(word) > width_) {
      const std::size_t end = end_in_word(width_of_, width_, word);
      put(word.substr(0, end));
      word.remove_prefix(end);
      if (!word.empty()) begin_line();
    }
    put(word);
  }
  void begin_line() {
    text_ += '\n';
    at_ = 0;
    is_empty_ = true;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void put(std::string_view piece) {
    text_ += piece;
    at_ += width_of_(piece);
    is_empty_ = false;
  }

  const TextWidth& width_of_;
  float width_, blank_;
  std::string text_;
  float at_ = 0;
  bool is_empty_ = true;  ///< the line has no word yet
};

}  // namespace

std::string cut_to(const TextWidth& width_of, float width, const std::string& text) {
  constexpr const char* dots = "...";
  if (width_of(text) <= width) return text;
  return text.substr(0, bytes_that_fit(width_of, width - width_of(dots), text)) + dots;
}

std::string in_lines(const TextWidth& width_of, float width, const std::string& text) {
  BrokenLines lines(width_of, width);
  std::string_view left = text;
  while (true) {
    const std::size_t end = std::min(left.find_first_of(" \n"), left.size());
    lines.add(left.substr(0, end));
    if (end == left.size()) return lines.text();
    if (left[end] == '\n') lines.begin_line();
    left.remove_prefix(end + 1);
  }
}

std::vector<float> apart(std::span<const float> wanted, float size, float from, float to) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wanted[i]; });
  std::vector<float> places(wanted.size());
  for (const std::size_t i : order) {
    places[i] = std::max(wanted[i], from);
    from = places[i] + size;
  }
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    places[*i] = std::min(places[*i], to - size);
    to = places[*i];
  }
  return places;
}

}  // namespace throng::app
