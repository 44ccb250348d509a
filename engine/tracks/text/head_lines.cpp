#include "engine/tracks/text/head_lines.h"

#include <algorithm>
#include <string>

namespace throng {
namespace {

constexpr std::string_view viswalk_mark = "$VISION";

/// A line of a text, without its end and the blanks around it.
struct TextLine {
  std::string_view text;
  std::size_t byte = 0, number = 1;
};

/// Returns the lines of a text one after the other.
class LineWalk {
 public:
  explicit LineWalk(std::string_view text) : text_(text), at_(byte_order_mark(text)) {}

  bool next(TextLine& line) {
    if (at_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    line = {text_.substr(at_, end - at_), at_, ++count_};
    at_ = std::min(end + 1, text_.size());
    return true;
  }
  std::size_t byte() const { return at_; }
  std::size_t number() const { return count_ + 1; }

 private:
  std::string_view text_;
  std::size_t at_, count_ = 0;
};

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view without_line_end(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// "sep=;", which Excel writes and reads.
bool is_separator_line(std::string_view line) { return line.size() == 5 && line.starts_with("sep="); }

/// Returns whether a line has a unit for each column, or nothing, and at least one unit.
bool is_line_of_units(std::string_view line, std::string_view names) {
  const char separator = separator_of(names);
  const std::vector<std::string> units = fields_of(line, separator);
  const auto says_nothing = [](const std::string& unit) { return unit.empty() || unit == "-"; };
  const auto says_unit = [&](const std::string& unit) {
    return says_nothing(unit) || is_unit(std::string_view(unit).substr(0, unit.find('/')));
  };
  return units.size() == fields_of(names, separator).size() && std::ranges::all_of(units, says_unit) &&
         !std::ranges::all_of(units, says_nothing);
}

}  // namespace

HeadLines lines_of(std::string_view head) {
  HeadLines lines;
  LineWalk walk(head);
  bool is_viswalk = false;
  for (TextLine line; lines.second.empty() && walk.next(line);) {
    const std::string_view text = without_blanks(line.text);
    if (text.empty() || (lines.first.empty() && is_separator_line(text))) continue;
    if (lines.first.empty() && text == viswalk_mark) {
      is_viswalk = true;
    } else if (is_comment(text) || (is_viswalk && text.front() == '*')) {
      if (lines.first.empty())
        lines.comments.push_back(text.substr(std::min(text.find_first_not_of("#%/*"), text.size())));
    } else if (lines.first.empty()) {
      lines.first = without_line_end(line.text);
      lines.first_byte = line.byte;
      lines.first_line = line.number;
      lines.body_byte = walk.byte();
      lines.body_line = walk.number();
    } else if (lines.units.empty() && is_line_of_units(text, lines.first)) {
      lines.units = text;
      lines.body_byte = walk.byte();
      lines.body_line = walk.number();
    } else {
      lines.second = without_line_end(line.text);
    }
  }
  return lines;
}

void take_units(const HeadLines& lines, TableLayout& layout) {
  const std::vector<std::string> units = fields_of(lines.units, layout.separator);
  for (std::size_t i = 0; i < std::min(units.size(), layout.columns.size()); ++i) {
    if (layout.columns[i].unit.empty()) layout.columns[i].unit = units[i];
  }
}

std::size_t byte_order_mark(std::string_view head) { return head.starts_with("\xEF\xBB\xBF") ? 3 : 0; }

}  // namespace throng
