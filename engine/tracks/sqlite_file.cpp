#include "engine/tracks/sqlite_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "engine/anim/bake/parallel.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"
#include "engine/tracks/database.h"
#include "engine/tracks/page_rows.h"
#include "engine/tracks/progress_clock.h"
#include "engine/tracks/reading_threads.h"
#include "engine/tracks/text/number_text.h"
#include "engine/tracks/text_rows.h"

namespace throng {
namespace {

using Tables = std::vector<Database::Table>;

const Database::Table* table_named(const Tables& tables, std::string_view name) {
  const auto found = std::ranges::find(tables, name, &Database::Table::name);
  return found == tables.end() ? nullptr : &*found;
}

bool has_columns(const Database::Table* table, std::initializer_list<const char*> names) {
  return table != nullptr &&
         std::ranges::all_of(names, [&](const char* name) { return std::ranges::count(table->columns, name) > 0; });
}

Error wrong_tables(const Tables& tables) {
  std::vector<std::string> shown;
  for (const Database::Table& table : tables) {
    if (shown.size() < 8) shown.push_back(plain_text(table.name + "(" + joined(table.columns) + ")"));
  }
  return {(shown.empty() ? "it has no table" : "it has the tables " + joined(shown, ", ", " and ") + ", but") +
          std::string(shown.empty() ? " " : " not ") +
          "trajectory_data(frame, id, pos_x, pos_y), which JuPedSim writes; export rows as CSV"};
}

/// Reads the metadata.
Status read_metadata(Database& database, const Tables& tables, RowFacts& facts) {
  facts.format = "JuPedSim SQLite";
  if (!has_columns(table_named(tables, "metadata"), {"key", "value"})) return Done{};
  return database.for_rows("SELECT key, value FROM metadata LIMIT 1000", [&](const DatabaseRow& row) {
    const std::string key(row.text(0));
    double number = 0.0;
    const bool is_number = is_number_text(row.text(1), number);
    if (key == "fps" && is_number && number > 0.0 && number <= 10'000.0) facts.rate = number;
    if (key == "version") facts.format += ", version " + plain_text(row.text(1).substr(0, 8));
    return true;
  });
}

/// Reads the place. Where it changes, the first place counts.
Status read_place(Database& database, const Tables& tables, FilePlan& plan, std::vector<std::string>& remarks) {
  const Database::Table* const geometry = table_named(tables, "geometry");
  if (!has_columns(geometry, {"wkt"})) return Done{};
  const bool has_hash = has_columns(geometry, {"hash"});
  std::optional<std::int64_t> first;
  if (has_hash && has_columns(table_named(tables, "frame_data"), {"frame", "geometry_hash"})) {
    Status found =
        database.for_rows("SELECT geometry_hash FROM frame_data ORDER BY frame LIMIT 1", [&](const DatabaseRow& row) {
          first = row.whole(0);
          return false;
        });
    if (!found) return found;
  }
  const std::string where = first ? " WHERE hash = " + std::to_string(*first) : "";
  Status parsed = Done{};
  const Status read = database.for_rows("SELECT wkt FROM geometry" + where + " LIMIT 1", [&](const DatabaseRow& row) {
    auto place = parse_wkt(row.text(0));
    if (place) plan = std::move(*place);
    if (!place) parsed = Error{"its geometry: " + place.error().message};
    return false;
  });
  if (!read || !parsed) return read ? parsed : read;
  return database.for_rows("SELECT count(*) FROM geometry", [&](const DatabaseRow& row) {
    if (row.whole(0) > 1) {
      remarks.push_back("The place changes " + counted(static_cast<std::size_t>(row.whole(0) - 1), "time") +
                        "; it is drawn as it is at first.");
    }
    return false;
  });
}

/// The rows that one thread reads.
struct RowRange {
  std::int64_t first = 0, last = 0;  ///< of rowid
  bool is_all = false;               ///< the table has no rowid
};

std::string where_of(const RowRange& range) {
  if (range.is_all) return "";
  return " WHERE rowid BETWEEN " + std::to_string(range.first) + " AND " + std::to_string(range.last) +
         " ORDER BY rowid";
}

/// Cuts the rows into one range a thread.
std::vector<RowRange> ranges_of(Database& database) {
  std::int64_t first = 0, last = -1;
  const Status counted =
      database.for_rows("SELECT min(rowid), max(rowid) FROM trajectory_data", [&](const DatabaseRow& row) {
        first = row.whole(0);
        last = row.kind(0) == DatabaseRow::Kind::nothing ? -1 : row.whole(1);
        return false;
      });
  if (!counted) return {{.is_all = true}};
  if (last < first) return {};
  const auto span = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
  const std::uint64_t count = span < 20'000 ? 1 : reading_threads();
  std::vector<RowRange> ranges;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t from = span / count * i, to = i + 1 == count ? span : span / count * (i + 1) - 1;
    ranges.push_back({static_cast<std::int64_t>(static_cast<std::uint64_t>(first) + from),
                      static_cast<std::int64_t>(static_cast<std::uint64_t>(first) + to), false});
  }
  return ranges;
}

/// Holds the result of reading a range.
struct ReadRange {
  RowSink sink;
  std::vector<RowBlock> blocks;
  std::size_t bad = 0;
  std::string first_bad;
  bool is_refused = false;
  Status status = Done{};
};

constexpr std::array<const char*, 6> column_names{"frame", "id", "pos_x", "pos_y", "ori_x", "ori_y"};

bool refuse(RowSink& sink, int column, const DatabaseRow& row) {
  const auto kind = row.kind(column);
  const std::string name = column_names[static_cast<std::size_t>(column)];
  const std::string what = kind == DatabaseRow::Kind::nothing ? "NULL"
                           : kind == DatabaseRow::Kind::bytes ? "a blob"
                           : kind == DatabaseRow::Kind::text  ? in_quotes(row.text(column).substr(0, 40))
                           : column == 1                      ? "no whole number"
                                                              : "not finite";
  sink.fault = name + " is " + what + "; put " + (column == 1 ? "an id" : "a number") + " there";
  return false;
}

bool read_row(const DatabaseRow& row, bool has_direction, RowSink& sink) {
  RawRow raw;
  const auto number = [&](int column, double& value) { return row.number(column, value) && std::isfinite(value); };
  if (!number(0, raw.time)) return refuse(sink, 0, row);
  if (!number(2, raw.x)) return refuse(sink, 2, row);
  if (!number(3, raw.y)) return refuse(sink, 3, row);
  if (has_direction) {
    double x = 0.0, y = 0.0;
    if (!number(4, x)) return refuse(sink, 4, row);
    if (!number(5, y)) return refuse(sink, 5, row);
    raw.angle = heading_of_direction(x, y);
  }
  const auto kind = row.kind(1);
  const bool is_whole_real =
      kind == DatabaseRow::Kind::real && std::abs(row.real(1)) < 9e15 && row.real(1) == std::floor(row.real(1));
  if (kind == DatabaseRow::Kind::whole || is_whole_real) {
    raw.person = sink.ids.number_of(row.whole(1));
  } else if (kind == DatabaseRow::Kind::text && !row.text(1).empty()) {
    raw.person = sink.ids.number_of(row.text(1).substr(0, 100));
  } else {
    return refuse(sink, 1, row);
  }
  return add_row(raw, sink);
}

void end_block(std::size_t table, ReadRange& read) {
  if (read.sink.rows.empty()) return;
  read.blocks.push_back({take_rows_of(read.sink), table});
}

/// Reads a range on a connection of its own. `tell` is called with the count of rows now and then.
template <typename Tell>
void read_range(Database& database, const RowRange& range, bool has_direction, bool is_lenient, std::size_t table,
                ReadRange& read, Tell tell) {
  constexpr std::size_t block_rows = 32 * 1024;
  std::size_t count = 0;
  const std::string columns = std::string("frame, id, pos_x, pos_y") + (has_direction ? ", ori_x, ori_y" : "") +
                              (range.is_all ? "" : ", rowid");
  const int rowid = has_direction ? 6 : 4;
  read.status =
      database.for_rows("SELECT " + columns + " FROM trajectory_data" + where_of(range), [&](const DatabaseRow& row) {
        ++count;
        if (!read_row(row, has_direction, read.sink)) {
          const std::string number = range.is_all ? std::to_string(count) : std::to_string(row.whole(rowid));
          if (read.bad++ == 0) read.first_bad = "row " + number + " of trajectory_data: " + read.sink.fault;
          read.is_refused = !is_lenient;
          return is_lenient;
        }
        if (read.sink.rows.size() == block_rows) {
          end_block(table, read);
          tell(count);
          return read.sink.ids.size() <= most_people;
        }
        return true;
      });
  end_block(table, read);
}

/// Reads the rows on as many connections as threads help.
Status read_with_sqlite(const std::string& file, Database& database, bool has_direction, const TrackReading& options,
                        const ReadProgress& progress, RawTracks& tracks) {
  const std::vector<RowRange> ranges = ranges_of(database);
  std::vector<ReadRange> read(ranges.size());
  ProgressClock clock(progress);
  anim::in_parallel(ranges.size(), [&](std::size_t i) {
    if (ranges.empty()) return;
    auto own = Database::open(file);
    if (!own) {
      read[i].status = own.error();
      return;
    }
    read[i].sink.most = most_metres / options.metres_a_unit.value_or(1.0);
    const double span = static_cast<double>(ranges[i].last) - static_cast<double>(ranges[i].first) + 1.0;
    read_range(*own, ranges[i], has_direction, options.lenient, i, read[i], [&](std::size_t count) {
      if (i == 0) clock.show(std::min(1.0, static_cast<double>(count) / span));
    });
  });
  for (ReadRange& range : read) {
    if (range.is_refused) return row_error(file, range.first_bad);
    if (!range.status) return Error{file + ": " + range.status.error().message};
    if (tracks.bad_rows == 0) tracks.first_bad_row = range.first_bad;
    tracks.bad_rows += range.bad;
    std::ranges::move(range.blocks, std::back_inserter(tracks.blocks));
    tracks.tables.push_back(std::move(range.sink.ids));
  }
  return Done{};
}

}  // namespace

Status read_sqlite(const std::string& file, const TrackReading& options, const ReadProgress& progress,
                   RawTracks& tracks) {
  const auto named = [&](const Error& error) { return Error{file + ": " + error.message}; };
  auto database = Database::open(file);
  if (!database) return named(database.error());
  const auto tables = database->tables();
  if (!tables) return named(tables.error());
  const Database::Table* const rows = table_named(*tables, "trajectory_data");
  if (!has_columns(rows, {"frame", "id", "pos_x", "pos_y"})) return named(wrong_tables(*tables));
  const bool has_direction = has_columns(rows, {"ori_x", "ori_y"});
  tracks.facts.has_frames = true;
  if (has_direction) tracks.facts.angle = AngleMeaning::heading;
  if (const Status read = read_metadata(*database, *tables, tracks.facts); !read) return named(read.error());
  if (options.walls.empty()) {
    const Status read = read_place(*database, *tables, tracks.plan, tracks.facts.remarks);
    if (!read) return named(read.error());
  }
  if (read_page_rows(file, *rows, options, progress, tracks)) return Done{};
  return read_with_sqlite(file, *database, has_direction, options, progress, tracks);
}

bool is_sqlite(std::string_view head) { return head.starts_with("SQLite format 3"); }

Result<FilePlan> read_sqlite_plan(const std::string& file) {
  auto database = Database::open(file);
  if (!database) return Error{file + ": " + database.error().message};
  const auto tables = database->tables();
  if (!tables) return Error{file + ": " + tables.error().message};
  FilePlan plan;
  std::vector<std::string> remarks;
  if (const Status read = read_place(*database, *tables, plan, remarks); !read) {
    return Error{file + ": " + read.error().message};
  }
  return plan;
}

}  // namespace throng
