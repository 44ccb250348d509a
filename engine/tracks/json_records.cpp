#include "engine/tracks/json_records.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/base/files/input_file.h"
#include "engine/base/json/json.h"
#include "engine/tracks/ndjson.h"
#include "engine/tracks/text/clock_text.h"
#include "engine/tracks/text/head_lines.h"
#include "engine/tracks/text/known_keys.h"
#include "engine/tracks/text/number_text.h"
#include "engine/tracks/text/table_layout.h"
#include "engine/tracks/text_format.h"
#include "engine/tracks/text_rows.h"

namespace throng {
namespace {

/// The values of a record and of the objects around it, by field; null where no object has it.
using FieldValues = std::array<const Json*, track_field_count>;

const Json* field_value(const FieldValues& values, TrackField field) { return values[static_cast<std::size_t>(field)]; }

bool is_number_in(const Json& json, TrackField field, double& number) {
  if (json.is_number()) {
    number = json.get<double>();
  } else if (json.is<std::string>()) {
    const auto text = json.get<std::string>();
    const bool is_time = field == TrackField::time && is_clock_text(text, number);
    if (!is_time && !is_number_text(text, number)) return false;
  } else {
    return false;
  }
  return std::isfinite(number);
}

std::string id_text(const Json& json) { return json.is<std::string>() ? json.get<std::string>() : json.dump(); }

/// Walks through a document, which parse_json() lets be 64 deep.
class RecordWalk {
 public:
  RecordWalk(RowSink& sink, bool is_lenient) : sink_(sink), is_lenient_(is_lenient) {}

  /// Returns false after a record that is refused, which `first_bad` says.
  bool take(const Json& json, FieldValues around) {
    for (const Json& element : json.elements()) {
      if (!take(element, around)) return false;
    }
    FieldRanks ranks;
    for (const Json::Member& member : json.members()) {
      if (is_structure(member.value)) continue;
      const KnownKeys::Key& key = keys_.of(member.key);
      if (ranks.takes(key)) around[static_cast<std::size_t>(key.column.field)] = &member.value;
    }
    const bool has_place = ranks.has(TrackField::x) && ranks.has(TrackField::y);
    if (has_place && !add(around)) return false;
    for (const Json::Member& member : json.members()) {
      if (is_structure(member.value) && !take(member.value, around)) return false;
    }
    return sink_.ids.size() <= most_people;
  }

  std::size_t records() const { return records_; }
  std::size_t bad() const { return bad_; }
  const std::string& first_bad() const { return first_bad_; }
  /// Returns the columns that the first record has.
  const TableLayout& layout() const { return layout_; }

 private:
  static bool is_structure(const Json& json) { return json.is_array() || json.is_object(); }

  bool add(const FieldValues& values) {
    ++records_;
    if (records_ == 1) {
      for (const KnownKeys::Key& key : keys_.all()) {
        const bool is_here = key.column.field != TrackField::none && field_value(values, key.column.field) != nullptr;
        if (is_here && !layout_.has(key.column.field)) layout_.columns.push_back(key.column);
      }
    }
    RawRow row;
    if (is_row(values, row) && add_row(row, sink_)) return true;
    if (bad_++ == 0) first_bad_ = "record " + std::to_string(records_) + ": " + sink_.fault;
    return is_lenient_;
  }

  bool is_row(const FieldValues& values, RawRow& row) {
    const Json* const id = field_value(values, TrackField::id);
    if (id == nullptr) return refuse("it has no id of a person; add \"id\"");
    const TrackField when = layout_.has(TrackField::time) ? TrackField::time : TrackField::frame;
    double z = 0.0, angle = 0.0;
    if (!take_number(values, when, row.time) || !take_number(values, TrackField::x, row.x) ||
        !take_number(values, TrackField::y, row.y)) {
      return false;
    }
    const bool has_z = field_value(values, TrackField::z) != nullptr,
               has_angle = field_value(values, TrackField::angle) != nullptr;
    if ((has_z && !take_number(values, TrackField::z, z)) ||
        (has_angle && !take_number(values, TrackField::angle, angle)))
      return false;
    row.z = static_cast<float>(z);
    if (has_angle) row.angle = static_cast<float>(angle);
    std::array<char, 32> digits;
    row.person = sink_.ids.number_of(plain_id(id_text(*id), digits));
    return true;
  }

  bool take_number(const FieldValues& values, TrackField field, double& number) {
    const Json* const value = field_value(values, field);
    const std::string name = field == TrackField::x       ? "x"
                             : field == TrackField::y     ? "y"
                             : field == TrackField::z     ? "z"
                             : field == TrackField::angle ? "an angle"
                                                          : "time or frame";
    if (value == nullptr) return refuse("it has no " + name + "; add it");
    return is_number_in(*value, field, number) ||
           refuse(value->dump().substr(0, 40) + " is no number; put " + name + " there");
  }

  bool refuse(std::string fault) {
    sink_.fault = std::move(fault);
    return false;
  }

  RowSink& sink_;
  bool is_lenient_;
  KnownKeys keys_;
  TableLayout layout_;
  std::size_t records_ = 0, bad_ = 0;
  std::string first_bad_;
};

}  // namespace

bool is_json_document(std::string_view head) {
  const HeadLines lines = lines_of(head);
  const std::size_t first = lines.first.find_first_not_of(" \t");
  if (first == std::string_view::npos) return false;
  if (lines.first[first] == '[') return true;
  if (lines.first[first] != '{' || lines.second.starts_with('{') || ndjson_format(lines.first)) return false;
  return !parse_json(lines.first) || lines.first.find('[') != std::string_view::npos;
}

Status read_json_records(const std::string& file, const TrackReading& options, RawTracks& tracks) {
  const auto text = read_text(file, "a file of JSON", most_json_bytes);
  if (!text) return Error{file + ": " + text.error().message + "; put the object of a row on each line, or export CSV"};
  const auto json = parse_json(*text);
  if (!json) return Error{file + ": its text " + json.error().message + "; export it again"};
  RowSink sink;
  RecordWalk walk(sink, options.lenient);
  const bool is_read = walk.take(*json, {});
  if (sink.ids.size() > most_people) return too_many_people(file);
  if (!is_read) return row_error(file, walk.first_bad());
  if (walk.records() == 0) {
    return Error{
        file + ": it is JSON without an object that has x and y; name them so beside \"id\" and \"time\" or \"frame\""};
  }
  take_columns(walk.layout(), tracks.facts);
  tracks.facts.format = "JSON records";
  tracks.bad_rows = walk.bad();
  tracks.first_bad_row = walk.first_bad();
  tracks.blocks.push_back({.rows = take_rows_of(sink), .table = 0});
  tracks.tables.push_back(std::move(sink.ids));
  return Done{};
}

}  // namespace throng
