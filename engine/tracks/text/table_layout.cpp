#include "engine/tracks/text/table_layout.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include "engine/base/text/joined.h"

namespace throng {
namespace {

struct FieldNames {
  TrackField field;
  std::string_view words;  ///< in lower case, letters and digits alone, the most common first
};

constexpr std::array field_names{
    FieldNames{TrackField::id,
               "id person personid agent agentid ped pedid pedestrian pedestrianid track trackid occupant occupantid "
               "people peopleid human humanid actor actorid object objectid particle particleid pid p no name"},
    FieldNames{TrackField::time,
               "time t seconds sec s timestamp simtime simsec timesec timesteptime elapsedtime starttimepid1"},
    FieldNames{TrackField::frame, "frame frameid fr f framenumber frameno framenum frameindex timestep step tick"},
    FieldNames{
        TrackField::x,
        "x posx xpos positionx xposition px xcoord coordx coordcentx xcoordinate locationx worldx centerx xcenter cx "
        "startx startxpid1 xpid1"},
    FieldNames{
        TrackField::y,
        "y posy ypos positiony yposition py ycoord coordy coordcenty ycoordinate locationy worldy centery ycenter cy "
        "starty startypid1 ypid1"},
    FieldNames{TrackField::z,
               "z posz zpos positionz zposition pz zcoord coordz coordcentz zcoordinate locationz worldz centerz cz "
               "height elevation"},
    FieldNames{TrackField::angle, "angle heading orientation yaw theta ori direction rotation phi ang headingangle"},
    FieldNames{TrackField::direction_x, "orix dirx directionx headingx orientationx"},
    FieldNames{TrackField::direction_y, "oriy diry directiony headingy orientationy"},
    FieldNames{TrackField::end_time, "endtime endtimepid1"},
    FieldNames{TrackField::end_x, "endx endxpid1"},
    FieldNames{TrackField::end_y, "endy endypid1"},
};

constexpr std::array<std::string_view, 17> units{"m",  "cm", "mm",  "km",     "ft",      "in",  "s",       "sec", "ms",
                                                 "us", "ns", "deg", "degree", "degrees", "rad", "radians", "min"};

std::string letters_and_digits(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) result += c;
  }
  return result;
}

/// Vadere ends a name with the number of the processor that wrote it: "startxpid5" is "startxpid1".
std::string of_first_processor(std::string word) {
  const std::size_t end = word.find_last_not_of("0123456789");
  const bool has_number = end != std::string::npos && end + 1 < word.size();
  if (has_number && std::string_view(word).substr(0, end + 1).ends_with("pid")) word.replace(end + 1, word.npos, "1");
  return word;
}

bool has_word(std::string_view words, std::string_view wanted) {
  while (!words.empty()) {
    const std::size_t blank = std::min(words.find(' '), words.size());
    if (words.substr(0, blank) == wanted) return true;
    words.remove_prefix(std::min(blank + 1, words.size()));
  }
  return false;
}

/// Takes a unit off the end of a name: "x [m]", "x(m)", "x/m", "x_m", "x in m".
std::string unit_taken_off(std::string& name) {
  for (const std::string_view before : {"[", "(", "/", "_", " in "}) {
    const std::size_t at = name.rfind(before);
    if (at == std::string::npos || at == 0) continue;
    std::string unit = letters_and_digits(std::string_view(name).substr(at + before.size()));
    if (!is_unit(unit)) continue;
    name.resize(at);
    return unit;
  }
  return {};
}

std::string_view words_of(TrackField field) {
  for (const FieldNames& names : field_names) {
    if (names.field == field) return names.words;
  }
  return {};
}

/// "id (person, personid, agent, ...)".
std::string acceptable(TrackField field) {
  std::string_view words = words_of(field);
  std::vector<std::string> shown;
  while (!words.empty() && shown.size() < 4) {
    const std::size_t blank = std::min(words.find(' '), words.size());
    shown.emplace_back(words.substr(0, blank));
    words.remove_prefix(std::min(blank + 1, words.size()));
  }
  const std::string first = shown.front();
  shown.erase(shown.begin());
  return first + " (" + joined(shown) + ", ...)";
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool TableLayout::has(TrackField field) const { return column_of(field) != nullptr; }

const TableColumn* TableLayout::column_of(TrackField field) const {
  const auto found = std::ranges::find(columns, field, &TableColumn::field);
  return found == columns.end() ? nullptr : &*found;
}

char separator_of(std::string_view line) {
  char best = ' ';
  std::ptrdiff_t most = 0;
  for (const char separator : {';', '\t', ','}) {
    std::ptrdiff_t count = 0;
    bool is_quoted = false;
    for (const char c : line) {
      if (c == '"') is_quoted = !is_quoted;
      if (c == separator && !is_quoted) ++count;
    }
    if (count > most) {
      most = count;
      best = separator;
    }
  }
  return best;
}

std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  std::string field;
  bool is_quoted = false;
  const auto add = [&] {
    while (!field.empty() && std::isspace(static_cast<unsigned char>(field.back())) != 0) field.pop_back();
    const std::size_t first = field.find_first_not_of(" \t");
    field.erase(0, std::min(first, field.size()));
    if (separator != ' ' || !field.empty()) fields.push_back(field);
    field.clear();
  };
  for (const char c : line) {
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && (c == separator || (separator == ' ' && (c == '\t' || c == '\r')))) {
      add();
    } else {
      field += c;
    }
  }
  add();
  return fields;
}

bool is_unit(std::string_view word) { return std::ranges::count(units, word) > 0; }

TableColumn column_named(std::string_view name) {
  std::string text = lower_case(name);
  if (const std::size_t colon = text.find(':'); text.starts_with('$') && colon != std::string::npos) {
    text.erase(0, colon + 1);  // $PEDESTRIAN:NO of Viswalk
  }
  TableColumn column{.field = TrackField::none, .name = std::string(name), .unit = unit_taken_off(text)};
  const std::string word = of_first_processor(letters_and_digits(text));
  for (const FieldNames& names : field_names) {
    if (has_word(names.words, word)) column.field = names.field;
  }
  return column;
}

std::size_t rank_of(const TableColumn& column) {
  std::string text = lower_case(column.name);
  unit_taken_off(text);
  return words_of(column.field).find(letters_and_digits(text));
}

TableLayout layout_of_header(std::string_view line, std::string_view prefix) {
  TableLayout layout{.separator = separator_of(line), .columns = {}, .is_whole = true};
  for (const std::string& name : fields_of(line, layout.separator)) {
    const bool has_prefix = !prefix.empty() && lower_case(name).starts_with(prefix);
    TableColumn column = column_named(has_prefix ? std::string_view(name).substr(prefix.size()) : name);
    const bool is_other = !prefix.empty() && !has_prefix && column.field != TrackField::time;
    if (is_other) column.field = TrackField::none;
    column.name = name;
    const auto same = std::ranges::find(layout.columns, column.field, &TableColumn::field);
    if (column.field != TrackField::none && same != layout.columns.end()) {
      const bool is_better = rank_of(column) < rank_of(*same);
      (is_better ? same->field : column.field) = TrackField::none;
    }
    layout.columns.push_back(std::move(column));
  }
  return layout;
}

std::string missing_fields(const TableLayout& layout) {
  std::vector<std::string> missing;
  if (!layout.has(TrackField::id)) missing.push_back(acceptable(TrackField::id));
  if (!layout.has(TrackField::time) && !layout.has(TrackField::frame)) {
    missing.push_back(acceptable(TrackField::time) + " or " + acceptable(TrackField::frame));
  }
  if (!layout.has(TrackField::x)) missing.push_back(acceptable(TrackField::x));
  if (!layout.has(TrackField::y)) missing.push_back(acceptable(TrackField::y));
  return joined(missing, ", ", " and ");
}

bool has_columns_of(std::string_view header, std::string_view prefix) {
  bool has_time = false, has_id = false;
  for (const std::string& name : fields_of(header, separator_of(header))) {
    const std::string word = letters_and_digits(lower_case(name));
    has_time = has_time || word == "timesteptime";
    has_id = has_id || word == std::string(prefix) + "id";
  }
  return has_time && has_id;
}

}  // namespace throng
