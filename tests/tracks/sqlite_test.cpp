#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/tracks/track_file.h"

namespace throng::sqlite_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Runs statements on a new database.
std::string database(const TrackFolder& folder, const std::string& statements, const char* name = "a.sqlite") {
  const std::string path = folder.path(name);
  std::filesystem::remove(path);
  sqlite3* handle = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
  char* message = nullptr;
  EXPECT_EQ(sqlite3_exec(handle, statements.c_str(), nullptr, nullptr, &message), SQLITE_OK) << message;
  sqlite3_close(handle);
  return path;
}

constexpr const char* metadata =
    "CREATE TABLE metadata(key TEXT, value TEXT); INSERT INTO metadata VALUES('version', '2'), ('fps', '10.0');";

std::string rows_with_direction(const std::string& values) {
  return std::string(metadata) +
         "CREATE TABLE trajectory_data(frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL, pos_y REAL "
         "NOT "
         "NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL); INSERT INTO trajectory_data VALUES" +
         values + ";";
}

constexpr const char* plain = "CREATE TABLE trajectory_data(frame, id, pos_x, pos_y);";

TEST(JuPedSim, ReadsRowsDirectionsAndPlace) {
  const TrackFolder folder;
  const std::string file = database(
      folder, rows_with_direction("(0,7,1.5,2,0,0),(1,7,1.5,2.5,0,1),(1,8,4,4,1,0)") +
                  "CREATE TABLE geometry(hash INTEGER, wkt TEXT); INSERT INTO geometry VALUES(5, 'POLYGON ((0 0, 9 "
                  "0, 9 9, 0 9, 0 0), (2 2, 3 2, 3 3, 2 2))'), (6, 'POLYGON ((0 0, 1 0, 1 1, 0 0))');"
                  "CREATE TABLE frame_data(frame INTEGER, geometry_hash INTEGER);"
                  "INSERT INTO frame_data VALUES(1, 6), (0, 5);");
  const auto tracks = read_trajectories(file, {});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "JuPedSim SQLite, version 2");
  ASSERT_EQ(tracks->persons.size(), 2U);
  EXPECT_EQ(tracks->persons[0].id, "7");
  EXPECT_EQ(tracks->persons[0].rows[1].seconds, 0.1);
  EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[1]), glm::dvec2(1.5, 2.5));
  EXPECT_TRUE(std::isnan(tracks->persons[0].rows[0].heading));                        // no direction
  EXPECT_NEAR(std::abs(tracks->persons[0].rows[1].heading), std::numbers::pi, 1e-6);  // north is -Z
  EXPECT_NEAR(tracks->persons[1].rows[0].heading, std::numbers::pi / 2.0, 1e-6);
  ASSERT_EQ(tracks->plan.floors.size(), 1U);
  EXPECT_EQ(tracks->plan.floors[0].outline.size(), 4U);
  EXPECT_EQ(tracks->plan.floors[0].holes.size(), 1U);
  EXPECT_THAT(all_said(*tracks), HasSubstr("The place changes 1 time"));
}

TEST(JuPedSim, ReadsFilesOfTheFirstVersionWithoutDirections) {
  const TrackFolder folder;
  const auto tracks = read_trajectories(
      database(folder,
               std::string(plain) +
                   "INSERT INTO trajectory_data VALUES(0,1,0,0),(1,1,0,0.04);"
                   "CREATE TABLE metadata(key TEXT, value TEXT); INSERT INTO metadata VALUES('version', '1');"
                   "CREATE TABLE geometry(wkt TEXT); INSERT INTO geometry VALUES('POLYGON ((0 0, 1 0, 1 1))');"),
      {});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->rows_a_second, 25.0);
  EXPECT_THAT(all_said(*tracks), HasSubstr("does not say its frame rate"));
  EXPECT_EQ(tracks->plan.floors.size(), 1U);
  EXPECT_TRUE(std::isnan(tracks->persons[0].rows[0].heading));
}

TEST(JuPedSim, ReadsManyRowsOnTwoConnectionsAsOnOne) {
  const TrackFolder folder;
  const std::string counted =
      "WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 59999) SELECT i / 100, i % 100, i % "
      "100, i "
      "/ 100 * 0.01 FROM n";
  const auto with = read_trajectories(
      database(folder,
               "CREATE TABLE trajectory_data(frame INTEGER, id INTEGER, pos_x REAL, pos_y REAL); INSERT INTO "
               "trajectory_data " +
                   counted),
      {.fps = 25.0});
  const auto without = read_trajectories(
      database(
          folder,
          "CREATE TABLE trajectory_data(frame INTEGER, id INTEGER, pos_x REAL, pos_y REAL, PRIMARY KEY (frame, id)) "
          "WITHOUT ROWID; INSERT INTO trajectory_data " +
              counted,
          "b.sqlite"),
      {.fps = 25.0});
  ASSERT_TRUE(with) << with.error().message;
  ASSERT_TRUE(without) << without.error().message;
  for (const Trajectories* tracks : {&*with, &*without}) {
    ASSERT_EQ(tracks->persons.size(), 100U);
    EXPECT_EQ(tracks->row_count, 60'000U);
    for (std::size_t i = 0; i < 100; ++i) {
      EXPECT_EQ(tracks->persons[i].id, std::to_string(i));
      ASSERT_EQ(tracks->persons[i].rows.size(), 600U);
      EXPECT_EQ(tracks->persons[i].rows[599].seconds, 599 / 25.0);
    }
  }
}

TEST(JuPedSim, TakesTheLastOfDuplicatesWhateverThreadReadsIt) {
  const TrackFolder folder;
  const auto tracks = read_trajectories(
      database(
          folder,
          "CREATE TABLE trajectory_data(frame INTEGER, id INTEGER, pos_x REAL, pos_y REAL); WITH RECURSIVE n(i) AS "
          "(SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 199999) INSERT INTO trajectory_data SELECT i / 10 % 10, i "
          "% 10, i * 0.01, 0.5 FROM n"),
      {.fps = 1.0});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(found(*tracks, TrackOddity::duplicate), 199'900U);
  ASSERT_EQ(tracks->row_count, 100U);
  for (const PersonTrack& person : tracks->persons) {
    for (const TrackRow& row : person.rows) EXPECT_GT(file_place(*tracks, row).x, 1998.99);
  }
}

TEST(JuPedSim, RefusesRowsByTheirNumber) {
  const TrackFolder folder;
  const auto message = [&](const char* values) {
    const auto read =
        read_trajectories(database(folder, std::string(plain) + "INSERT INTO trajectory_data VALUES" + values), {});
    return read ? std::string() : read.error().message;
  };
  EXPECT_THAT(
      message("(0,1,0,0),(1,1,'abc',0)"),
      HasSubstr("a.sqlite: row 2 of trajectory_data: pos_x is \"abc\"; put a number there, or skip such rows with "
                "--lenient"));
  EXPECT_THAT(message("(NULL,1,0,0)"), HasSubstr("frame is NULL"));
  EXPECT_THAT(message("(0,x'00',0,0)"), HasSubstr("id is a blob; put an id there"));
  EXPECT_THAT(message("(0,1,0,9e999)"), HasSubstr("pos_y is not finite"));
  EXPECT_THAT(message("(0,1,0,2e7)"), HasSubstr("more than 10,000 km off"));
}

TEST(JuPedSim, SkipsWrongRowsWhereItMay) {
  const TrackFolder folder;
  const auto tracks = read_trajectories(
      database(folder, std::string(plain) + "INSERT INTO trajectory_data VALUES(0,1,0,0),(1,1,'abc',0),(2,1,0,NULL)"),
      {.lenient = true});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->row_count, 1U);
  EXPECT_EQ(found(*tracks, TrackOddity::bad_row), 2U);
  EXPECT_THAT(tracks->report.found[0].first, HasSubstr("row 2 of trajectory_data"));
}

TEST(JuPedSim, NamesTheTablesOfAnotherDatabase) {
  const TrackFolder folder;
  const auto read = read_trajectories(database(folder, "CREATE TABLE people(name, age)"), {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message,
              HasSubstr("it has the tables people(name, age), but not trajectory_data(frame, id, pos_x, pos_y)"));
  EXPECT_FALSE(read_trajectories(database(folder, "CREATE TABLE trajectory_data(frame, id, x, y)"), {}));
  const auto bare = read_trajectories(database(folder, "CREATE VIEW v AS SELECT 1"), {});
  ASSERT_FALSE(bare);
  EXPECT_THAT(bare.error().message, HasSubstr(": it has no table trajectory_data(frame, id, pos_x, pos_y), which"));
  const auto empty = read_trajectories(database(folder, plain), {});
  ASSERT_FALSE(empty);
  EXPECT_THAT(empty.error().message, HasSubstr("it has no rows"));
}

TEST(JuPedSim, RefusesAViewInPlaceOfTheTable) {
  const TrackFolder folder;
  const auto read = read_trajectories(
      database(folder,
               "CREATE TABLE t(i); CREATE VIEW trajectory_data AS SELECT 0 AS frame, 1 AS id, 2 AS pos_x, 3 AS "
               "pos_y"),
      {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("but not trajectory_data"));
}

TEST(JuPedSim, RefusesColumnsThatTheFileComputes) {
  const TrackFolder folder;
  const auto read = read_trajectories(
      database(folder,
               "CREATE TABLE trajectory_data(frame, id, pos_x, pos_y AS (length(printf('%60000000d', id)))); INSERT "
               "INTO trajectory_data VALUES(0, 1, 2)"),
      {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("it has the tables trajectory_data(frame, id, pos_x, pos_y (computed))"));
}

/// Writes rows, of which the last lie in the journal beside the file when it returns: the writer goes on.
class UnfinishedDatabase {
 public:
  UnfinishedDatabase(const std::string& file, const std::string& journal_mode) {
    EXPECT_EQ(sqlite3_open(file.c_str(), &handle_), SQLITE_OK);
    run("PRAGMA journal_mode = " + journal_mode + "; PRAGMA cache_size = 1; PRAGMA cache_spill = 1;");
    run(rows_with_direction("(0,1,0,0,0,0)"));
    run("BEGIN; WITH RECURSIVE n(i) AS (SELECT 1 UNION SELECT i + 1 FROM n WHERE i < 20000) INSERT INTO "
        "trajectory_data SELECT i, 1, 0, 0, 0, 0 FROM n;");
    if (journal_mode == "WAL") run("COMMIT");
  }
  UnfinishedDatabase(const UnfinishedDatabase&) = delete;
  UnfinishedDatabase& operator=(const UnfinishedDatabase&) = delete;
  ~UnfinishedDatabase() { sqlite3_close(handle_); }

 private:
  void run(const std::string& statements) {
    char* message = nullptr;
    EXPECT_EQ(sqlite3_exec(handle_, statements.c_str(), nullptr, nullptr, &message), SQLITE_OK) << message;
  }

  sqlite3* handle_ = nullptr;
};

TEST(JuPedSim, RefusesAFileWhoseLastRowsLieBesideIt) {
  for (const char* const mode : {"WAL", "DELETE"}) {
    const TrackFolder folder;
    const std::string file = folder.path("a.sqlite");
    const auto writer = std::make_unique<UnfinishedDatabase>(file, mode);
    const auto read = read_trajectories(file, {});
    ASSERT_FALSE(read) << mode;
    EXPECT_THAT(read.error().message,
                HasSubstr(std::string("its writer has not finished it and keeps rows in ") + file +
                          (mode == std::string("WAL") ? "-wal" : "-journal") + "; end that program, or run: sqlite3 '"))
        << mode;
  }
}

TEST(JuPedSim, ReadsAFileWhoseWriterHasEnded) {
  for (const char* const mode : {"WAL", "PERSIST", "TRUNCATE"}) {
    const TrackFolder folder;
    const std::string file =
        database(folder, std::string("PRAGMA journal_mode = ") + mode + ";" + rows_with_direction("(0,1,0,0,0,0)"));
    EXPECT_TRUE(read_trajectories(file, {})) << mode;
  }
}

TEST(JuPedSim, RefusesAFileThatIsCutOff) {
  const TrackFolder folder;
  std::string values;
  for (int i = 0; i < 5000; ++i) values += (i > 0 ? ",(" : "(") + std::to_string(i) + ",1,0.5,0.5,0,0)";
  const std::string file = database(folder, rows_with_direction(values));
  const auto size = std::filesystem::file_size(file);
  for (const auto left : {size / 2, size - 100, std::uintmax_t{600}, std::uintmax_t{20}}) {
    const std::string cut = folder.path("cut.sqlite");
    std::filesystem::copy_file(file, cut, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(cut, left);
    const auto read = read_trajectories(cut, {});
    ASSERT_FALSE(read) << left;
    EXPECT_THAT(read.error().message, StartsWith(cut + ": it cannot be read as a database")) << left;
    EXPECT_THAT(read.error().message, HasSubstr("; export it anew")) << left;
  }
}

TEST(JuPedSim, LeavesFolderAndFileAsTheyAre) {
  const TrackFolder folder;
  const std::string file =
      database(folder, "PRAGMA journal_mode = WAL;" + rows_with_direction("(0,1,0,0,0,0)"), "50% a?#.sqlite");
  std::ofstream(file + "-journal") << "something of others";
  const auto before = std::filesystem::last_write_time(file);
  const auto tracks = read_trajectories(file, {});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(std::filesystem::last_write_time(file), before);
  EXPECT_TRUE(std::filesystem::exists(file + "-journal"));
  EXPECT_FALSE(std::filesystem::exists(file + "-shm"));
}

TEST(JuPedSim, SaysWhatIsWrongWithItsGeometry) {
  const TrackFolder folder;
  const auto read = read_trajectories(
      database(folder, std::string(plain) +
                           "INSERT INTO trajectory_data VALUES(0,1,0,0);"
                           "CREATE TABLE geometry(wkt TEXT); INSERT INTO geometry VALUES('POLYGON ((0 0, 1')"),
      {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("its geometry: line 1: it ends where a number should be"));
}

}  // namespace
}  // namespace throng::sqlite_test
