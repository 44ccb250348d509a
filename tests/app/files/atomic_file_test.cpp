#include "app/files/atomic_file.h"

#include <fstream>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/temporary_folder.h"

namespace throng::app::atomic_file_test {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public test::TemporaryFolder {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path().filename().string());
    return all;
  }

  static std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }

  const fs::path file_ = folder_ / "report.json";
};

TEST_F(AtomicFile, IsWholeAndAlone) {
  ASSERT_TRUE(write_whole_file(file_, "one"));
  ASSERT_TRUE(write_whole_file(file_, "two and more"));
  EXPECT_EQ(read(file_), "two and more");
  EXPECT_THAT(names(), testing::ElementsAre("report.json"));
}

TEST_F(AtomicFile, KeepsAnEmptyText) {
  ASSERT_TRUE(write_whole_file(file_, ""));
  EXPECT_TRUE(fs::exists(file_));
}

TEST_F(AtomicFile, NamesTheFileInAFolderThatIsNotThere) {
  const auto status = write_whole_file(folder_ / "absent" / "report.json", "text");
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, testing::HasSubstr((folder_ / "absent" / "report.json").string()));
  EXPECT_THAT(status.error().message, testing::HasSubstr("No such file or directory"));
}

TEST_F(AtomicFile, LeavesNothingWhereItCannotBeRenamed) {
  fs::create_directories(file_ / "child");
  EXPECT_FALSE(write_whole_file(file_, "text"));
  EXPECT_THAT(names(), testing::ElementsAre("report.json"));
}

TEST_F(AtomicFile, WritesThroughASymbolicLink) {
  fs::create_symlink(folder_ / "real.json", file_);
  ASSERT_TRUE(write_whole_file(folder_ / "real.json", "old"));
  ASSERT_TRUE(write_whole_file(file_, "new"));
  EXPECT_TRUE(fs::is_symlink(file_));
  EXPECT_EQ(read(folder_ / "real.json"), "new");
}

TEST_F(AtomicFile, DoesNotReplaceADevice) {
  ASSERT_TRUE(write_whole_file("/dev/null", "text"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_FALSE(write_whole_file("/dev/full", "text"));
}

TEST_F(AtomicFile, IsCheckedWithoutATrace) {
  EXPECT_TRUE(check_can_be_written("--stats", file_));
  EXPECT_THAT(names(), testing::IsEmpty());
}

TEST_F(AtomicFile, IsLeftAsItWasByTheCheck) {
  ASSERT_TRUE(write_whole_file(file_, "old"));
  EXPECT_TRUE(check_can_be_written("--stats", file_));
  EXPECT_EQ(read(file_), "old");
}

TEST_F(AtomicFile, CheckNamesOptionFileAndReason) {
  const fs::path file = folder_ / "absent" / "a.png";
  const auto status = check_can_be_written("--screenshot", file);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "--screenshot " + file.string() + ": cannot be written: No such file or directory");
}

TEST_F(AtomicFile, CheckRefusesAFolder) {
  const auto status = check_can_be_written("--stats", folder_);
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, testing::HasSubstr("Is a directory"));
}

}  // namespace
}  // namespace throng::app::atomic_file_test
