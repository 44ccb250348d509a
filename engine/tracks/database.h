#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace throng {

/// A row of an answer.
class DatabaseRow {
 public:
  enum class Kind : std::uint8_t { nothing, whole, real, text, bytes };

  explicit DatabaseRow(sqlite3_stmt* statement) : statement_(statement) {}
  Kind kind(int column) const;
  std::int64_t whole(int column) const;
  double real(int column) const;
  std::string_view text(int column) const;  ///< until the next row
  /// Writes the number in a column to `value`; returns false if there is none.
  bool number(int column, double& value) const;

 private:
  sqlite3_stmt* statement_;
};

/// A database file that is only read. Neither views, triggers, computed columns nor functions of the file run.
class Database {
 public:
  /// Errors: the file is no whole database, or a journal beside it holds rows that are not in it yet.
  static Result<Database> open(const std::string& file);

  /// Calls visit(row) for each row of an answer until it returns false.
  /// The error is the end of a sentence: the database is broken, or has no such table.
  Status for_rows(const std::string& query, const std::function<bool(const DatabaseRow&)>& visit);

  struct Table {
    std::string name;
    std::vector<std::string> columns;  ///< "x (computed)" where the file computes x, which has no value here
    std::uint32_t root_page = 0;
    bool is_plain = false;  ///< records have all columns in this order
  };
  /// Returns the tables of the file, without views and virtual tables.
  Result<std::vector<Table>> tables();

 private:
  explicit Database(std::shared_ptr<sqlite3> handle) : handle_(std::move(handle)) {}
  Error failure() const;

  std::shared_ptr<sqlite3> handle_;
};

}  // namespace throng
