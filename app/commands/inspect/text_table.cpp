#include "app/commands/inspect/text_table.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace throng::app {
namespace {

/// Counts letters, not bytes: leaves out bytes that continue a letter of UTF-8.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

bool is_number(const std::string& cell) {
  return !cell.empty() && std::isdigit(static_cast<unsigned char>(cell.front())) != 0;
}

}  // namespace

std::string TextTable::text(std::size_t indent) const {
  std::vector<std::size_t> widths(lines_.front().size(), 0);
  for (const auto& line : lines_) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width_of(line[i]));
  }
  std::string text;
  for (const auto& line : lines_) {
    std::string row(indent, ' ');
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string room(widths[i] - width_of(line[i]), ' ');
      const bool is_right = i > 0 && (is_number(line[i]) || (&line == &lines_.front() && heads_numbers(i)));
      row += is_right ? room + line[i] : line[i] + room;
      row += "  ";
    }
    text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

bool TextTable::heads_numbers(std::size_t column) const {
  return std::all_of(lines_.begin() + 1, lines_.end(), [&](const auto& line) { return is_number(line[column]); });
}

}  // namespace throng::app
