#include "engine/tracks/table_parser.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/base/text/plain_text.h"
#include "engine/tracks/text/clock_text.h"
#include "engine/tracks/text/head_lines.h"
#include "engine/tracks/text/number_text.h"

namespace throng {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

constexpr std::size_t index_of(TrackField field) { return static_cast<std::size_t>(field); }

/// What a cell of each TrackField holds, in its order.
constexpr std::array<std::string_view, track_field_count> meanings{"a number",
                                                                   "the person's id",
                                                                   "the time in seconds",
                                                                   "the number of the frame",
                                                                   "x in metres",
                                                                   "y in metres",
                                                                   "z in metres",
                                                                   "an angle",
                                                                   "a part of the direction",
                                                                   "a part of the direction",
                                                                   "the end of the step in seconds",
                                                                   "x of the step's end in metres",
                                                                   "y of the step's end in metres"};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

const char* after_blanks(const char* at, const char* end, char separator) {
  while (at < end && is_blank(*at) && (*at != separator || separator == ' ')) ++at;
  return at;
}

/// Returns the end of the cell that begins at `at`: a separator or the line's end.
const char* end_of_cell(const char* at, const char* end, char separator) {
  bool is_quoted = false;
  for (; at < end; ++at) {
    if (*at == '"') is_quoted = !is_quoted;
    if (!is_quoted && (*at == separator || (separator == ' ' && *at == '\t'))) break;
  }
  return at;
}

std::string_view cell_text(const char* at, const char* end) {
  while (end > at && is_blank(end[-1])) --end;
  if (end - at >= 2 && *at == '"' && end[-1] == '"') return {at + 1, static_cast<std::size_t>(end - at) - 2};
  return {at, static_cast<std::size_t>(end - at)};
}

/// Returns the text of a quoted cell with one quote for two: ""a"" is "a".
std::string with_single_quotes(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"') ++i;
    result += text[i];
  }
  return result;
}

/// Returns the first letters of a cell, for an error.
std::string shown(std::string_view text) {
  return "\"" + plain_text(text.substr(0, 40)) + (text.size() > 40 ? "...\"" : "\"");
}

bool is_value(TrackField field, std::string_view text, bool may_have_comma, double& value) {
  const bool is_time = field == TrackField::time || field == TrackField::end_time;
  return is_number_text(text, value) || (may_have_comma && is_decimal_comma_text(text, value)) ||
         (is_time && is_clock_text(text, value));
}

}  // namespace

struct TableParser::Cells {
  std::string_view id;
  bool has_quotes = false;  ///< two quotes stand for one in the id
  std::array<double, track_field_count> numbers;

  double operator[](TrackField field) const { return numbers[index_of(field)]; }
};

TableParser::TableParser(TableLayout layout) : layout_(std::move(layout)) {
  time_ = layout_.has(TrackField::time) ? TrackField::time : TrackField::frame;
  has_direction_ = layout_.has(TrackField::direction_x) && layout_.has(TrackField::direction_y);
  const bool has_ends =
      layout_.has(TrackField::end_time) && layout_.has(TrackField::end_x) && layout_.has(TrackField::end_y);
  for (TableColumn& column : layout_.columns) {
    if (time_ == TrackField::time && column.field == TrackField::frame) column.field = TrackField::none;
    const bool is_end =
        column.field == TrackField::end_time || column.field == TrackField::end_x || column.field == TrackField::end_y;
    if (is_end && !has_ends) column.field = TrackField::none;
  }
  known_count_ = layout_.columns.size();
  while (known_count_ > 0 && layout_.columns[known_count_ - 1].field == TrackField::none) --known_count_;
}

bool TableParser::read(std::string_view line, RowSink& sink) {
  const char* const end = line.data() + line.size();
  const char* const at = after_blanks(line.data(), end, layout_.separator);
  if (at == end || is_comment({at, static_cast<std::size_t>(end - at)})) return true;
  Cells cells;
  cells.numbers.fill(no_number);
  return read_cells(at, end, cells, sink) && add(cells, sink);
}

bool TableParser::read_cells(const char* at, const char* end, Cells& cells, RowSink& sink) const {
  const char separator = layout_.separator;
  for (std::size_t i = 0; i < known_count_; ++i) {
    const TrackField field = layout_.columns[i].field;
    at = after_blanks(at, end, separator);
    if (at == end && (separator == ' ' || (i > 0 && end[-1] != separator))) {
      return refuse_short(i, sink);
    }
    const char* stop = nullptr;
    if (field != TrackField::none && field != TrackField::id) {
      double& number = cells.numbers[index_of(field)];
      stop = read_number(at, end, number);
      if (stop != nullptr) stop = after_blanks(stop, end, separator);
      const bool is_whole = stop != nullptr && (stop == end || *stop == separator || separator == ' ');
      const bool ends_well = is_whole && (separator != ' ' || stop == end || is_blank(stop[-1]));
      if (!ends_well || !std::isfinite(number)) {
        stop = end_of_cell(at, end, separator);
        const std::string_view text = cell_text(at, stop);
        const bool is_left_out = text.empty() && layout_.may_be_empty;
        if (is_left_out) number = no_number;
        const bool may_have_comma = separator != ',' || (at < stop && *at == '"');
        if (!is_left_out && (!is_value(field, text, may_have_comma, number) || !std::isfinite(number))) {
          return refuse_cell(i, text, sink);
        }
      }
    } else {
      stop = end_of_cell(at, end, separator);
      if (field == TrackField::id) {
        cells.id = cell_text(at, stop);
        cells.has_quotes = at < stop && *at == '"' && cells.id.find("\"\"") != std::string_view::npos;
      }
    }
    at = stop < end && *stop == separator ? stop + 1 : stop;
  }
  return !layout_.is_whole || has_all_columns(at, end, sink);
}

/// Cells beyond the last column come of a decimal comma, of names of rows, or of another table.
bool TableParser::has_all_columns(const char* at, const char* end, RowSink& sink) const {
  const char separator = layout_.separator;
  std::size_t count = known_count_;
  bool is_over = separator != ' ' && at[-1] != separator;
  for (; !is_over && count < layout_.columns.size(); ++count) {
    at = after_blanks(at, end, separator);
    if (separator == ' ' && at == end) break;
    at = end_of_cell(at, end, separator);
    is_over = at == end;
    if (!is_over && separator != ' ') ++at;
  }
  if (count < layout_.columns.size() && !layout_.may_be_empty) return refuse_short(count, sink);
  while (at < end && (is_blank(*at) || *at == separator)) ++at;
  if (at == end || *at == '#') return true;
  sink.fault = "it goes on after its " + std::to_string(layout_.columns.size()) +
               " columns; name each column, write numbers with a point, and names with a comma in quotes";
  return false;
}

bool TableParser::refuse_short(std::size_t count, RowSink& sink) const {
  const std::size_t all = layout_.is_whole ? layout_.columns.size() : known_count_;
  sink.fault = "it has " + std::to_string(count) + (count == 1 ? " column" : " columns") + ", but " +
               layout_.columns[all - 1].name + " is column " + std::to_string(all) + "; put what is missing there";
  return false;
}

bool TableParser::refuse_cell(std::size_t column, std::string_view text, RowSink& sink) const {
  double number = 0.0;
  const bool is_number = is_number_text(text, number);
  const std::string_view wrong = text.empty() ? " is no number" : is_number ? " is not finite" : " is not a number";
  sink.fault = (text.empty() ? "an empty cell" : shown(text)) + std::string(wrong) + "; put " +
               std::string(meanings[index_of(layout_.columns[column].field)]) + " there";
  if (text.find(',') != std::string_view::npos) sink.fault += ", with a point instead of the comma";
  return false;
}

bool TableParser::add(const Cells& cells, RowSink& sink) const {
  if (cells.id.empty()) {
    if (layout_.may_be_empty) return true;
    sink.fault = "the person's id is empty; put one there";
    return false;
  }
  RawRow row{.time = cells[time_], .x = cells[TrackField::x], .y = cells[TrackField::y]};
  if (std::isnan(row.time) || std::isnan(row.x) || std::isnan(row.y)) {
    sink.fault = "time, x or y is empty; put a number there";
    return false;
  }
  if (const double z = cells[TrackField::z]; !std::isnan(z)) row.z = static_cast<float>(z);
  if (has_direction_) {
    row.angle = heading_of_direction(cells[TrackField::direction_x], cells[TrackField::direction_y]);
  } else {
    row.angle = static_cast<float>(cells[TrackField::angle]);
  }
  std::array<char, 32> digits;
  row.person = sink.ids.number_of(cells.has_quotes ? with_single_quotes(cells.id) : plain_id(cells.id, digits));
  if (!add_row(row, sink)) return false;
  const double end_time = cells[TrackField::end_time];
  if (std::isnan(end_time)) return true;
  row.time = end_time;
  row.x = cells[TrackField::end_x];
  row.y = cells[TrackField::end_y];
  return add_row(row, sink);
}

}  // namespace throng
