#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/tracks/text/table_layout.h"

namespace throng {

/// The first lines of a text. All views are into it.
struct HeadLines {
  std::vector<std::string_view> comments;  ///< the comments before the first other line, without their mark
  std::string_view first = {};             ///< the first line that is no comment and not empty
  std::string_view second = {};            ///< the next such line
  std::string_view units = {};             ///< the line below names that says their units, as Pathfinder writes it
  std::size_t first_byte = 0, first_line = 1;
  std::size_t body_byte = 0, body_line = 1;  ///< of the row below names and units; the text's end if there is none
};

/// Returns whether a line that begins with no blank is a comment: after # or, as in Matlab, %, or after //.
inline bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

/// Returns the first lines of a text. Comments begin with * in files of Viswalk, too. Excel's line sep=; is left out.
HeadLines lines_of(std::string_view head);

/// Gives columns without a unit the one in the line of units, if there is such a line.
void take_units(const HeadLines& lines, TableLayout& layout);

/// Returns how many bytes a mark of UTF-8 at the front takes.
std::size_t byte_order_mark(std::string_view head);

}  // namespace throng
