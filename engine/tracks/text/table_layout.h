#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace throng {

/// Says what a column of a table holds.
enum class TrackField : std::uint8_t {
  none,
  id,
  time,
  frame,
  x,
  y,
  z,
  angle,
  direction_x,
  direction_y,
  end_time,  // of a row that is a step from (x, y) at `time`
  end_x,
  end_y,
};
inline constexpr std::size_t track_field_count = 13;

struct TableColumn {
  TrackField field = TrackField::none;
  std::string name;  ///< as the file has it
  std::string unit;  ///< "cm", "deg"; empty where the name has none
};

/// Says how the lines of a table become rows.
struct TableLayout {
  char separator = ' ';  ///< ' ' means any run of blanks and tabs
  std::vector<TableColumn> columns;
  bool may_be_empty = false;  ///< a line without an id says nothing, as in tables of SUMO
  bool is_whole = false;      ///< a line has no more columns

  bool has(TrackField field) const;
  const TableColumn* column_of(TrackField field) const;
};

std::string lower_case(std::string_view text);

/// Returns the separator of a line: the most frequent of ; tab , in it, or ' '.
char separator_of(std::string_view line);

/// Returns the fields of a line, without quotes and the blanks around them.
std::vector<std::string> fields_of(std::string_view line, char separator);

/// Returns whether a word is a unit that columns may have: "m", "deg".
bool is_unit(std::string_view word);

/// Returns what the name of a column means, and its unit: "X [cm]" is x in cm. Case does not matter.
TableColumn column_named(std::string_view name);

/// Returns how uncommon a name is among its field's names: of the id and the name in a table of Pathfinder, the id
/// counts.
std::size_t rank_of(const TableColumn& column);

/// Names the columns of a header. `prefix` is left out of names: "person" for person_x. Of two columns for one field,
/// the first is taken.
TableLayout layout_of_header(std::string_view line, std::string_view prefix = {});

/// Returns the fields that a table lacks, with names for them, "id (person, agent, ...)"; empty if it lacks none.
std::string missing_fields(const TableLayout& layout);

/// Returns whether columns are called person_... or vehicle_..., beside the time of a step, as SUMO does.
bool has_columns_of(std::string_view header, std::string_view prefix);

}  // namespace throng
