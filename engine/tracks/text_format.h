#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"
#include "engine/tracks/text/table_layout.h"

namespace throng {

/// A format whose rows are lines, and how to read them.
struct TextFormat {
  RowFacts facts;
  std::unique_ptr<LineParser> parser;
  std::unique_ptr<LineParser> otherwise;  ///< reads the rows where `parser` finds none; often null
  std::size_t body = 0;                   ///< the byte at which rows begin
  std::size_t body_line = 1;              ///< its line
};

/// Takes the units in the names of columns, and which columns there are.
void take_columns(const TableLayout& layout, RowFacts& facts);

/// Finds the format of a text by its first lines, which `head` holds up to its last newline or the file's end.
/// The error is the end of a sentence that begins with the file's name.
Result<TextFormat> text_format_of(std::string_view head);

/// Returns whether whole lines hold the first row, so that text_format_of() can find the format.
bool has_first_row(std::string_view head);

/// Returns why bytes are no text that can be read, and what to do; empty if they may be. `remedy` is for bytes that are
/// no text at all.
std::string why_no_text(std::string_view head, std::string_view remedy =
                                                   "name a file of trajectories: CSV, text, XML, "
                                                   "ndjson or SQLite");

}  // namespace throng
