#include "engine/tracks/text_format.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"
#include "engine/tracks/first_rows.h"
#include "engine/tracks/ndjson.h"
#include "engine/tracks/table_parser.h"
#include "engine/tracks/text/head_lines.h"
#include "engine/tracks/text/number_text.h"

namespace throng {
namespace {

bool is_row_of_numbers(std::string_view line) {
  double number = 0.0;
  const std::vector<std::string> fields = fields_of(line, separator_of(line));
  return !fields.empty() && std::ranges::all_of(fields, [&](const std::string& field) {
    return field.empty() || is_number_text(field, number);
  });
}

/// Rows of numbers and a label, such as the rows of the Stanford drones.
bool is_mostly_numbers(std::string_view line) {
  double number = 0.0;
  const std::vector<std::string> fields = fields_of(line, separator_of(line));
  const auto count =
      std::ranges::count_if(fields, [&](const std::string& field) { return is_number_text(field, number); });
  return static_cast<std::size_t>(count) * 2 > fields.size();
}

/// Returns the number after `word` in a comment: "framerate: 25 fps".
std::optional<double> number_after(const std::string& comment, std::string_view word) {
  std::size_t at = comment.find(word);
  if (at == std::string::npos) return {};
  at = comment.find_first_of("0123456789.", at + word.size());
  if (at == std::string::npos) return {};
  double number = 0.0;
  const char* const end = comment.data() + comment.size();
  const bool is_rate = read_number(comment.data() + at, end, number) != nullptr && number > 0.0 && number <= 10'000.0;
  return is_rate ? std::optional(number) : std::nullopt;
}

std::optional<double> metres_of(const std::string& unit) {
  if (unit == "m") return 1.0;
  if (unit == "cm") return 0.01;
  if (unit == "mm") return 0.001;
  if (unit == "km") return 1000.0;
  if (unit == "ft") return 0.3048;
  if (unit == "in") return 0.0254;
  return {};
}

double units_a_second(const std::string& unit) {
  if (unit == "ms") return 1e3;
  if (unit == "us") return 1e6;
  if (unit == "ns") return 1e9;
  if (unit == "min") return 1.0 / 60.0;
  return 1.0;
}

/// Returns why two names cannot both be right: "x is in m, and y in cm"; empty if they can.
std::string unlike_units(const TableLayout& layout) {
  const TableColumn& x = *layout.column_of(TrackField::x);
  for (const TrackField field : {TrackField::y, TrackField::z}) {
    const TableColumn* const other = layout.column_of(field);
    const bool has_both = other != nullptr && metres_of(x.unit) && metres_of(other->unit);
    if (has_both && x.unit != other->unit) {
      return in_quotes(x.name) + " is in " + x.unit + ", and " + in_quotes(other->name) + " in " + other->unit +
             "; write both in one unit";
    }
  }
  return {};
}

/// Returns whether the columns are the ones that SUMO gives its people without a prefix.
bool is_plain_sumo(const TableLayout& layout) {
  return std::ranges::all_of(std::array{"type", "speed", "pos", "slope"}, [&](std::string_view name) {
    return std::ranges::count(layout.columns, name, &TableColumn::name) > 0;
  });
}

TableLayout layout_without_header(std::initializer_list<const char*> names) {
  TableLayout layout;
  for (const char* const name : names) layout.columns.push_back(column_named(name));
  return layout;
}

/// Takes frame rate and unit from comments.
void take_comments(const HeadLines& lines, RowFacts& facts) {
  for (const std::string_view line : lines.comments) {
    const std::string comment = lower_case(line);
    for (const std::string_view word : {"framerate", "frame rate", "fps"}) {
      if (!facts.rate) facts.rate = number_after(comment, word);
    }
    if (facts.unit) continue;
    if (comment.find("x/cm") != std::string::npos || comment.find("in cm") != std::string::npos) facts.unit = 0.01;
    if (comment.find("x/m") != std::string::npos || comment.find("in m") != std::string::npos) facts.unit = 1.0;
    if (facts.unit)
      facts.remarks.emplace_back(*facts.unit < 1.0 ? "A comment says centimetres." : "A comment says metres.");
  }
}

/// Returns the layout that a comment such as "# id frame x/m y/m z/m" names.
std::optional<TableLayout> layout_in_comments(const HeadLines& lines) {
  for (const std::string_view comment : lines.comments) {
    TableLayout layout = layout_of_header(comment);
    const bool is_short = layout.columns.size() <= fields_of(lines.first, separator_of(lines.first)).size();
    if (is_short && missing_fields(layout).empty()) return layout;
  }
  return {};
}

TextFormat archive_text(const HeadLines& lines, TableLayout layout) {
  TextFormat format;
  RowFacts& facts = format.facts;
  using enum TrackField;
  layout.separator = separator_of(lines.first);
  const bool is_jupedsim = layout.has(angle);  // JuPedSim has the ground's height where the archive has the head's
  take_comments(lines, facts);
  take_columns(layout, facts);
  if (is_jupedsim && facts.angle == AngleMeaning::unknown) facts.angle = AngleMeaning::degrees;
  facts.format = is_jupedsim ? "JuPedSim text" : "text of the Jülich archive";
  facts.z_is_head = facts.has_z && !is_jupedsim;
  facts.tells_unit = true;
  format.parser = std::make_unique<TableParser>(std::move(layout));
  return format;
}

TextFormat street_matrix() {
  TextFormat format;
  TableLayout layout = layout_without_header({"frame", "id", "x", "z", "y"});
  take_columns(layout, format.facts);
  format.facts.format = "ETH/UCY matrix (obsmat)";
  format.facts.rate_rule = RateRule::annotated;
  format.parser = std::make_unique<TableParser>(std::move(layout));
  return format;
}

/// Reads rows of four or five numbers without names, in the order that the first rows show.
TextFormat four_numbers(const HeadLines& lines, std::string_view rows, bool has_height) {
  const FirstColumns first = first_columns_of(rows, separator_of(lines.first));
  const char* const when = first.counts_frames ? "frame" : "time";
  TableLayout layout = first.frame_is_first ? layout_without_header({when, "id", "x", "y"})
                                            : layout_without_header({"id", when, "x", "y"});
  if (has_height) layout.columns.push_back(column_named("z"));
  TextFormat format = archive_text(lines, std::move(layout));
  if (!first.frame_is_first) return format;
  format.facts.format = "text with the frame first, as of ETH/UCY";
  format.facts.z_is_head = false;
  if (first.skips_frames) format.facts.rate_rule = RateRule::annotated;
  return format;
}

Error without_header(const HeadLines& lines) {
  const std::size_t columns = fields_of(lines.first, separator_of(lines.first)).size();
  return {"rows of " + counted(columns, "column") +
          " without a header; put a line before them that names the columns, such as id,frame,x,y"};
}

Result<TextFormat> table_without_header(const HeadLines& lines, std::string_view rows) {
  const std::size_t columns = fields_of(lines.first, separator_of(lines.first)).size();
  const bool has_blanks = separator_of(lines.first) == ' ' || separator_of(lines.first) == '\t';
  if (auto named = layout_in_comments(lines)) return archive_text(lines, *std::move(named));
  if (has_blanks && (columns == 4 || columns == 5)) return four_numbers(lines, rows, columns == 5);
  if (has_blanks && (columns == 7 || columns == 8)) return street_matrix();
  return without_header(lines);
}

Error unnamed(const HeadLines& lines, const std::string& missing) {
  std::vector<std::string> names;
  for (const std::string& field : fields_of(lines.first, separator_of(lines.first))) {
    if (names.size() < 20) names.push_back("\"" + plain_text(field.substr(0, 30)) + "\"");
  }
  return {"its columns are " + joined(names, ", ", " and ") + ", of which none is " + missing + "; name them so"};
}

/// Reads tables of SUMO: people, and vehicles where there are no people.
Result<TextFormat> sumo_table(const HeadLines& lines) {
  const bool has_people = has_columns_of(lines.first, "person"), has_vehicles = has_columns_of(lines.first, "vehicle");
  TableLayout layout = layout_of_header(lines.first, has_people ? "person_" : "vehicle_");
  if (const std::string missing = missing_fields(layout); !missing.empty()) return unnamed(lines, missing);
  layout.may_be_empty = true;
  TextFormat format;
  format.facts.format = "SUMO FCD table";
  take_columns(layout, format.facts);
  if (format.facts.angle != AngleMeaning::none) format.facts.angle = AngleMeaning::compass;
  format.parser = std::make_unique<TableParser>(std::move(layout));
  TableLayout vehicles = layout_of_header(lines.first, "vehicle_");
  vehicles.may_be_empty = true;
  if (has_people && has_vehicles && missing_fields(vehicles).empty()) {
    format.otherwise = std::make_unique<TableParser>(std::move(vehicles));
  }
  return format;
}

/// Takes frames for the time where times are rounded to less than a frame.
void prefer_frames(std::string_view rows, TableLayout& layout, RowFacts& facts) {
  if (!layout.has(TrackField::time) || !layout.has(TrackField::frame)) return;
  const RoundedTimes times = rounded_times_of(rows, layout);
  if (!times.are_rounded) return;
  const auto time = std::ranges::find(layout.columns, TrackField::time, &TableColumn::field);
  facts.remarks.push_back("Times are rounded: several rows of a person have one " + in_quotes(time->name) +
                          ". Frames are taken instead; --fps gives their rate.");
  if (times.rate) facts.rate = *times.rate * units_a_second(time->unit);
  time->field = TrackField::none;
}

Result<TextFormat> table_with_header(const HeadLines& lines, std::string_view rows) {
  if (has_columns_of(lines.first, "person") || has_columns_of(lines.first, "vehicle")) return sumo_table(lines);
  TableLayout layout = layout_of_header(lines.first);
  if (const std::string missing = missing_fields(layout); !missing.empty()) {
    return is_mostly_numbers(lines.first) ? without_header(lines) : unnamed(lines, missing);
  }
  take_units(lines, layout);
  if (std::string unlike = unlike_units(layout); !unlike.empty()) return Error{std::move(unlike)};
  TextFormat format;
  prefer_frames(rows, layout, format.facts);
  take_columns(layout, format.facts);
  const bool is_vadere = layout.has(TrackField::end_time) || lower_case(lines.first).find("-pid") != std::string::npos;
  if (is_vadere) {
    format.facts.format = "Vadere";
    format.facts.repeats_ends = true;
  } else if (is_plain_sumo(layout)) {
    format.facts.format = "SUMO FCD table";
    if (format.facts.angle == AngleMeaning::unknown) format.facts.angle = AngleMeaning::compass;
  } else {
    format.facts.format = "table with a header";
    take_comments(lines, format.facts);
  }
  format.parser = std::make_unique<TableParser>(std::move(layout));
  return format;
}

Result<TextFormat> with_body(Result<TextFormat> format, std::size_t body, std::size_t line) {
  if (!format) return Error{"line " + std::to_string(line) + ": " + format.error().message};
  format->body = body;
  format->body_line = line;
  return format;
}

}  // namespace

void take_columns(const TableLayout& layout, RowFacts& facts) {
  const TableColumn* const time = layout.column_of(TrackField::time);
  facts.has_frames = time == nullptr;
  if (time != nullptr) facts.times_a_second = units_a_second(time->unit);
  if (const auto metres = metres_of(layout.column_of(TrackField::x)->unit)) {
    facts.unit = metres;
    facts.remarks.push_back("The header says that x is in " + layout.column_of(TrackField::x)->unit + ".");
  }
  facts.has_z = layout.has(TrackField::z);
  if (layout.has(TrackField::direction_x) && layout.has(TrackField::direction_y)) {
    facts.angle = AngleMeaning::heading;
  } else if (const TableColumn* const angle = layout.column_of(TrackField::angle)) {
    facts.angle = angle->unit.starts_with("deg")   ? AngleMeaning::degrees
                  : angle->unit.starts_with("rad") ? AngleMeaning::radians
                                                   : AngleMeaning::unknown;
  }
}

bool has_first_row(std::string_view head) {
  const HeadLines lines = lines_of(head);
  if (lines.first.empty()) return false;
  return !lines.second.empty() || lines.first.find('{') == 0 || is_row_of_numbers(lines.first);
}

std::string why_no_text(std::string_view head, std::string_view remedy) {
  std::string no_text = "it is no text and no database; " + std::string(remedy);
  if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF")) return "it is UTF-16; save it as UTF-8";
  if (head.starts_with("\x1F\x8B")) return "it is packed; unpack it with gunzip";
  if (head.find('\n') == std::string_view::npos && std::ranges::count(head, '\r') > 1) {
    return "its lines end with a carriage return alone; save it with the ends of lines of Windows or Linux";
  }
  if (head.starts_with("PK\x03\x04")) return "it is a zip file or a spreadsheet; unpack it, or save it as CSV";
  const auto is_odd = [](char c) {
    return static_cast<unsigned char>(c) < ' ' && std::string_view("\t\n\r\f\v\0", 6).find(c) == std::string_view::npos;
  };
  if (std::ranges::any_of(head.substr(0, 1024), is_odd)) return no_text;
  if (const std::size_t zero = head.find('\0'); zero != std::string_view::npos) {
    const bool is_wide = head.size() > 3 && (head[1] == '\0') != (head[0] == '\0');
    return is_wide ? "it is UTF-16; save it as UTF-8" : no_text;
  }
  return {};
}

Result<TextFormat> text_format_of(std::string_view head) {
  if (const std::string why = why_no_text(head); !why.empty()) return Error{why};
  const HeadLines lines = lines_of(head);
  if (lines.first.empty()) {
    return Error{head.empty() ? "it is empty; name a file with rows" : "it has no rows; name a file with some"};
  }
  const std::size_t text = lines.first.find_first_not_of(" \t");
  if (lines.first[text] == '{' || lines.first[text] == '[')
    return with_body(ndjson_format(lines.first), lines.first_byte, lines.first_line);
  if (is_row_of_numbers(lines.first)) {
    return with_body(table_without_header(lines, head.substr(lines.first_byte)), lines.first_byte, lines.first_line);
  }
  auto table = with_body(table_with_header(lines, head.substr(lines.body_byte)), lines.body_byte, lines.first_line);
  if (table) table->body_line = lines.body_line;
  return table;
}

}  // namespace throng
