#include "engine/base/files/output_file.h"

#include <csignal>
#include <fstream>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/app/temporary_folder.h"

namespace throng::output_file_test {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public app::test::TemporaryFolder {
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

TEST_F(OutputFiles, IsWholeAndAlone) {
  ASSERT_TRUE(write_whole_file(file_, "one"));
  ASSERT_TRUE(write_whole_file(file_, "two and more"));
  EXPECT_EQ(read(file_), "two and more");
  EXPECT_THAT(names(), testing::ElementsAre("report.json"));
}

TEST_F(OutputFiles, KeepsAnEmptyText) {
  ASSERT_TRUE(write_whole_file(file_, ""));
  EXPECT_TRUE(fs::exists(file_));
}

TEST_F(OutputFiles, NamesTheFileInAFolderThatIsNotThere) {
  const auto status = write_whole_file(folder_ / "absent" / "report.json", "text");
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, testing::HasSubstr((folder_ / "absent" / "report.json").string()));
  EXPECT_THAT(status.error().message, testing::HasSubstr("No such file or directory"));
}

TEST_F(OutputFiles, LeavesNothingWhereItCannotBeRenamed) {
  fs::create_directories(file_ / "child");
  EXPECT_FALSE(write_whole_file(file_, "text"));
  EXPECT_THAT(names(), testing::ElementsAre("report.json"));
}

TEST_F(OutputFiles, WritesThroughASymbolicLink) {
  fs::create_symlink(folder_ / "real.json", file_);
  ASSERT_TRUE(write_whole_file(folder_ / "real.json", "old"));
  ASSERT_TRUE(write_whole_file(file_, "new"));
  EXPECT_TRUE(fs::is_symlink(file_));
  EXPECT_EQ(read(folder_ / "real.json"), "new");
}

TEST_F(OutputFiles, DoesNotReplaceADevice) {
  ASSERT_TRUE(write_whole_file("/dev/null", "text"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_FALSE(write_whole_file("/dev/full", "text"));
}

TEST_F(OutputFiles, IsCheckedWithoutATrace) {
  EXPECT_TRUE(check_can_be_written("--stats", file_));
  EXPECT_THAT(names(), testing::IsEmpty());
}

TEST_F(OutputFiles, IsLeftAsItWasByTheCheck) {
  ASSERT_TRUE(write_whole_file(file_, "old"));
  EXPECT_TRUE(check_can_be_written("--stats", file_));
  EXPECT_EQ(read(file_), "old");
}

TEST_F(OutputFiles, CheckNamesOptionFileAndReason) {
  const fs::path file = folder_ / "absent" / "a.png";
  const auto status = check_can_be_written("--screenshot", file);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message,
            "--screenshot " + file.string() +
                ": cannot be written: No such file or directory; make its folder, or name another file");
}

TEST_F(OutputFiles, CheckRefusesAFolder) {
  const auto status = check_can_be_written("--stats", folder_);
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, testing::HasSubstr("it is a folder"));
}

TEST_F(OutputFiles, KeepTheModeOfTheFileBefore) {
  ASSERT_TRUE(write_whole_file(file_, "old"));
  fs::permissions(file_, fs::perms::owner_all);
  ASSERT_TRUE(write_whole_file(file_, "new"));
  EXPECT_EQ(fs::status(file_).permissions(), fs::perms::owner_all);
}

TEST_F(OutputFiles, FollowALinkToAFileThatIsNotThereYet) {
  fs::create_symlink("real.json", file_);
  ASSERT_TRUE(write_whole_file(file_, "new"));
  EXPECT_EQ(read(folder_ / "real.json"), "new");
  EXPECT_TRUE(fs::is_symlink(file_));
}

TEST_F(OutputFiles, AreWrittenByTwoAtOnceWithoutMixing) {
  auto one = OutputFile::create(file_), other = OutputFile::create(file_);
  ASSERT_TRUE(one && other);
  EXPECT_NE(one->part(), other->part());
  ASSERT_TRUE(one->write("one") && other->write("other"));
  ASSERT_TRUE(one->commit());
  EXPECT_EQ(read(file_), "one");
  ASSERT_TRUE(other->commit());
  EXPECT_EQ(read(file_), "other");
  EXPECT_THAT(names(), testing::ElementsAre("report.json"));
}

TEST_F(OutputFiles, DoNotFollowALinkThatLiesWhereThePartGoes) {
  const fs::path victim = folder_ / "victim";
  ASSERT_TRUE(write_whole_file(victim, "precious"));
  fs::path part;
  {
    const auto first = OutputFile::create(file_);
    ASSERT_TRUE(first);
    part = first->part();
  }
  fs::create_symlink(victim, part);
  ASSERT_TRUE(write_whole_file(file_, "new"));
  EXPECT_EQ(read(victim), "precious");
  EXPECT_EQ(read(file_), "new");
}

TEST_F(OutputFiles, AreLeftAsTheyWereWithoutACommit) {
  ASSERT_TRUE(write_whole_file(file_, "old"));
  {
    auto output = OutputFile::create(file_);
    ASSERT_TRUE(output && output->write("half"));
  }
  EXPECT_EQ(read(file_), "old");
  EXPECT_THAT(names(), testing::ElementsAre("report.json"));
}

TEST_F(OutputFiles, RefuseAPipeThatNobodyReads) {
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  EXPECT_EQ(write_whole_file(file_, "text").error().message, file_.string() + ": cannot be written: it has no reader");
  EXPECT_TRUE(fs::is_fifo(file_)) << "it is not replaced";
}

TEST_F(OutputFiles, ThatCannotBeWrittenWholeAreAsTheyWere) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_TRUE(write_whole_file(file_, "old"));
  setrlimit(RLIMIT_FSIZE, &small);
  const Status written = write_whole_file(file_, std::string(100'000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, testing::HasSubstr("report.json: cannot be written: File too large"));
  EXPECT_EQ(read(file_), "old");
  EXPECT_THAT(names(), testing::ElementsAre("report.json"));
}

TEST_F(OutputFiles, OfKilledRunsAreFoundByTheirParts) {
  const pid_t child = fork();
  if (child == 0) {
    auto output = OutputFile::create(file_);
    _exit(output && output->write("half") ? 0 : 1);  // without a destructor, as kill -9 does it
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_EQ(status, 0);
  EXPECT_THAT(parts_left_beside(file_),
              testing::ElementsAre(fs::path(file_.string() + "." + std::to_string(child) + ".part")));
  const auto mine = OutputFile::create(file_);
  EXPECT_THAT(parts_left_beside(file_), testing::SizeIs(1)) << "one that is being written is not left";
  EXPECT_THAT(parts_left_beside(folder_ / "other.json"), testing::IsEmpty());
}

}  // namespace
}  // namespace throng::output_file_test
