#pragma once

#include <memory>
#include <string_view>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/text/table_layout.h"

namespace throng {

/// Reads the lines of a table, each a row, or two where a line is a step. Empty lines and comments have no rows.
class TableParser final : public LineParser {
 public:
  explicit TableParser(TableLayout layout);
  std::unique_ptr<LineParser> copy() const override { return std::make_unique<TableParser>(*this); }
  bool read(std::string_view line, RowSink& sink) override;

 private:
  struct Cells;
  bool read_cells(const char* at, const char* end, Cells& cells, RowSink& sink) const;
  bool has_all_columns(const char* at, const char* end, RowSink& sink) const;
  bool refuse_short(std::size_t count, RowSink& sink) const;
  bool add(const Cells& cells, RowSink& sink) const;
  bool refuse_cell(std::size_t column, std::string_view text, RowSink& sink) const;

  TableLayout layout_;
  TrackField time_ = TrackField::time;
  bool has_direction_ = false;
  std::size_t known_count_ = 0;  // of columns up to the last that is known
};

}  // namespace throng
