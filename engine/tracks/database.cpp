#include "engine/tracks/database.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <system_error>

#include <sqlite3.h>

#include "engine/base/files/input_file.h"
#include "engine/base/text/size_text.h"
#include "engine/tracks/text/table_layout.h"

namespace throng {
namespace {

/// Returns the address by which SQLite opens a file as an unchanging one.
std::string address_of(const std::string& file) {
  static constexpr char hex[] = "0123456789ABCDEF";
  std::string address = "file:";
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '?' || c == '#' || c == '%' || byte < 0x20) {
      address += {'%', hex[byte >> 4U], hex[byte & 15U]};
    } else {
      address += c;
    }
  }
  if (address.starts_with("file://")) address.insert(5, "//");  // no host, but a path that begins with two slashes
  return address + "?immutable=1";
}

constexpr std::string_view columns_pragma = "table_xinfo";

/// Lets statements read, and list the columns of a table.
int allow_reading(void* /*context*/, int action, const char* first, const char* /*second*/, const char* /*database*/,
                  const char* trigger_or_view) {
  const bool reads = action == SQLITE_SELECT || action == SQLITE_READ || action == SQLITE_FUNCTION;
  const bool lists_columns = action == SQLITE_PRAGMA && first == columns_pragma;
  return (reads || lists_columns) && trigger_or_view == nullptr ? SQLITE_OK : SQLITE_DENY;
}

/// SQLite calls it once a piece of work. A row may take 500 million operations, which are some ten seconds.
constexpr int operations_a_piece = 1'000'000, most_pieces = 500;
int is_too_much(void* pieces) { return ++*static_cast<int*>(pieces) > most_pieces ? 1 : 0; }

void bind_hands(sqlite3* handle) {
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, 64 << 20);
  sqlite3_limit(handle, SQLITE_LIMIT_SQL_LENGTH, 100'000);
  sqlite3_limit(handle, SQLITE_LIMIT_COLUMN, 200);
  sqlite3_limit(handle, SQLITE_LIMIT_EXPR_DEPTH, 20);
  sqlite3_limit(handle, SQLITE_LIMIT_COMPOUND_SELECT, 2);
  sqlite3_limit(handle, SQLITE_LIMIT_VDBE_OP, 25'000);
  sqlite3_limit(handle, SQLITE_LIMIT_FUNCTION_ARG, 8);
  sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, 0);
  sqlite3_limit(handle, SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 100);
  sqlite3_limit(handle, SQLITE_LIMIT_TRIGGER_DEPTH, 1);
  sqlite3_limit(handle, SQLITE_LIMIT_WORKER_THREADS, 0);
  sqlite3_exec(handle, "PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0", nullptr, nullptr, nullptr);
  sqlite3_set_authorizer(handle, allow_reading, nullptr);
}

/// Returns whether a file is there that begins with these bytes.
bool begins_with(const std::string& file, std::string_view bytes) {
  auto opened = InputFile::open(file);
  std::string begin(bytes.size(), '\0');
  if (!opened) return false;
  const auto read = opened->read(std::as_writable_bytes(std::span(begin)));
  return read && *read == bytes.size() && begin == bytes;
}

/// Returns the journal beside a database whose writer has not finished; empty if it has. A finished journal begins with
/// other bytes.
std::string journal_of(const std::string& file) {
  std::error_code error;
  std::filesystem::path real = std::filesystem::canonical(file, error);  // SQLite follows links, too
  if (error) real = file;
  std::string log = real.string() + "-wal", rollback = real.string() + "-journal";
  for (const std::string_view magic : {"\x37\x7F\x06\x82", "\x37\x7F\x06\x83"}) {
    if (begins_with(log, magic)) return log;
  }
  return begins_with(rollback, "\xD9\xD5\x05\xF9\x20\xA1\x63\xD7") ? rollback : std::string();
}

/// Returns how many bytes the header says that a database has; 0 where it does not say it.
std::uint64_t size_by_header(InputFile& file) {
  std::array<unsigned char, 100> header{};
  const auto read = file.read(std::as_writable_bytes(std::span(header)));
  if (!read || *read < header.size()) return 0;
  const auto number = [&](std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + count; ++i) value = value << 8U | header[i];
    return value;
  };
  const std::uint64_t page_bytes = number(16, 2) == 1 ? 65536 : number(16, 2);
  const bool is_valid = number(24, 4) == number(92, 4);  // an old program may have left a wrong count of pages
  return is_valid ? page_bytes * number(28, 4) : 0;
}

/// Returns whether the columns of a table lie in its records one after the other, by the statement that created it.
bool is_plain_table(std::string_view made) {
  const std::string lower = lower_case(made);
  for (const char* const word : {"without", "primary", "generated", " as", ")as"}) {
    if (lower.find(word) != std::string::npos) return false;
  }
  return true;
}

}  // namespace

DatabaseRow::Kind DatabaseRow::kind(int column) const {
  switch (sqlite3_column_type(statement_, column)) {
    case SQLITE_INTEGER:
      return Kind::whole;
    case SQLITE_FLOAT:
      return Kind::real;
    case SQLITE_TEXT:
      return Kind::text;
    case SQLITE_BLOB:
      return Kind::bytes;
    default:
      return Kind::nothing;
  }
}

std::int64_t DatabaseRow::whole(int column) const { return sqlite3_column_int64(statement_, column); }
double DatabaseRow::real(int column) const { return sqlite3_column_double(statement_, column); }

std::string_view DatabaseRow::text(int column) const {
  const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return text == nullptr ? std::string_view()
                         : std::string_view(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)));
}

bool DatabaseRow::number(int column, double& value) const {
  const int type = sqlite3_column_type(statement_, column);
  value = sqlite3_column_double(statement_, column);
  return type == SQLITE_INTEGER || type == SQLITE_FLOAT;
}

Result<Database> Database::open(const std::string& file) {
  auto input = InputFile::open(file, "a database");
  if (!input) return input.error();
  if (const std::uint64_t size = size_by_header(*input); size > input->size()) {
    return Error{"it cannot be read as a database (it is cut off after " + size_text(input->size()) + " of " +
                 size_text(size) + "); export it anew"};
  }
  if (const std::string journal = journal_of(file); !journal.empty()) {
    return Error{"its writer has not finished it and keeps rows in " + journal +
                 "; end that program, or run: sqlite3 '" + file + "' .tables"};
  }
  sqlite3* handle = nullptr;
  const int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX;
  const int status = sqlite3_open_v2(address_of(file).c_str(), &handle, flags, nullptr);
  Database database({handle, [](sqlite3* opened) { sqlite3_close_v2(opened); }});
  if (status != SQLITE_OK) return database.failure();
  bind_hands(handle);
  return database;
}

Error Database::failure() const {
  const std::string said = handle_ == nullptr ? "there is no memory left" : sqlite3_errmsg(handle_.get());
  return {"it cannot be read as a database (" + said + "); export it anew"};
}

Status Database::for_rows(const std::string& query, const std::function<bool(const DatabaseRow&)>& visit) {
  sqlite3_stmt* statement = nullptr;
  const int prepared = sqlite3_prepare_v2(handle_.get(), query.c_str(), -1, &statement, nullptr);
  const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> owner(statement, sqlite3_finalize);
  if (prepared != SQLITE_OK) return failure();
  const DatabaseRow row(statement);
  int status = SQLITE_ROW, pieces = 0;  // of work since the last row
  sqlite3_progress_handler(handle_.get(), operations_a_piece, is_too_much, &pieces);
  while ((status = sqlite3_step(statement)) == SQLITE_ROW) {
    pieces = 0;
    if (!visit(row)) return Done{};
  }
  if (status == SQLITE_INTERRUPT) return Error{"a row of it takes too much work; export its rows as CSV"};
  if (status != SQLITE_DONE) return failure();
  return Done{};
}

Result<std::vector<Database::Table>> Database::tables() {
  std::vector<Table> tables;
  const Status listed = for_rows(
      "SELECT name, rootpage, sql FROM sqlite_master WHERE type = 'table' AND rootpage > 0 AND name NOT LIKE 'sqlite%' "
      "LIMIT 100",
      [&](const DatabaseRow& row) {
        const std::int64_t root = row.whole(1);
        const bool is_page = root > 1 && root <= 0xFFFFFFFE;
        tables.push_back({std::string(row.text(0)),
                          {},
                          is_page ? static_cast<std::uint32_t>(root) : 0,
                          is_page && is_plain_table(row.text(2))});
        return true;
      });
  if (!listed) return listed.error();
  for (Table& table : tables) {
    std::string quoted;
    for (const char c : table.name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    constexpr int name = 1, hidden = 6;
    const Status columns =
        for_rows("PRAGMA " + std::string(columns_pragma) + "(\"" + quoted + "\")", [&](const DatabaseRow& row) {
          table.columns.push_back(std::string(row.text(name)) + (row.whole(hidden) == 0 ? "" : " (computed)"));
          return true;
        });
    if (!columns) return columns.error();
  }
  return tables;
}

}  // namespace throng
