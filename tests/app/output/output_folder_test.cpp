#include "app/output/output_folder.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/output/kept_lines.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::output_folder_test {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;

class FolderOfARun : public test::TemporaryFolder {
 protected:
  std::string refusal(const std::vector<std::string>& run) const {
    const auto opened = OutputFolder::open("--pictures", pictures_, run);
    return opened ? "(taken)" : opened.error().message;
  }

  const fs::path pictures_ = folder_ / "new" / "pictures";
  const std::vector<std::string> run_{"--agents", "20", "--size", "64x64"};
};

TEST_F(FolderOfARun, IsMadeAndNumbersItsFiles) {
  const auto opened = OutputFolder::open("--pictures", pictures_, run_);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->file("frame", 12), pictures_ / "frame_000012.png");
  EXPECT_EQ(opened->file("mask", 1234567), pictures_ / "mask_1234567.png");
}

TEST_F(FolderOfARun, IsTakenAgainByTheSameRunAlone) {
  ASSERT_EQ(refusal(run_), "(taken)");
  EXPECT_EQ(refusal(run_), "(taken)");
  const std::string refused = refusal({"--agents", "21"});
  EXPECT_THAT(refused, HasSubstr("--pictures " + pictures_.string() +
                                 ": is of another run, `throng --agents 20 --size 64x64` of throng "));
  EXPECT_THAT(refused, EndsWith("; name another folder, or remove this one"));
}

TEST_F(FolderOfARun, WithFilesOfNobodyKnowsWhoseIsRefused) {
  fs::create_directories(pictures_);
  std::ofstream(pictures_ / "holiday.png") << "beach";
  EXPECT_THAT(refusal(run_), EndsWith("has files, and no run.json says of which run; name another folder"));
}

TEST_F(FolderOfARun, WhoseNoteIsDamagedIsRefused) {
  fs::create_directories(pictures_);
  std::ofstream(pictures_ / "run.json") << "{";
  EXPECT_THAT(refusal(run_), HasSubstr("run.json"));
  std::ofstream(pictures_ / "run.json") << "{}";
  EXPECT_THAT(refusal(run_), HasSubstr("is of another run"));
}

TEST_F(FolderOfARun, ThatCannotBeMadeIsRefused) {
  std::ofstream(folder_ / "new") << "a file";
  EXPECT_THAT(refusal(run_), HasSubstr("cannot be made: "));
}

class LinesOfARun : public test::TemporaryFolder {
 protected:
  static std::string line(int frame) { return "{\"frame\":" + std::to_string(frame) + ",\"people\":[]}"; }
  const fs::path file_ = folder_ / "labels.jsonl";
};

TEST_F(LinesOfARun, AreThoseThatAreWholeAndInOrder) {
  std::ofstream(file_) << line(1) << '\n' << line(2) << '\n' << line(3).substr(0, 12);
  KeptLines lines(file_);
  EXPECT_EQ(lines.count(), 2);
  EXPECT_EQ(lines.next(), line(1));
  EXPECT_EQ(lines.next(), line(2));
  EXPECT_EQ(lines.next(), std::nullopt);
}

TEST_F(LinesOfARun, EndWhereOneIsMissing) {
  std::ofstream(file_) << line(1) << '\n' << line(3) << '\n';
  EXPECT_EQ(KeptLines(file_).count(), 1);
}

TEST_F(LinesOfARun, AreNoneWithoutAFile) {
  KeptLines lines(file_);
  EXPECT_EQ(lines.count(), 0);
  EXPECT_EQ(lines.next(), std::nullopt);
}

// No process has the largest number that there may be.
TEST_F(LinesOfARun, AreThoseThatAKilledRunHasLeftWhereItHasMore) {
  std::ofstream(file_) << line(1) << '\n';
  const fs::path part = folder_ / "labels.jsonl.4194303.part";
  std::ofstream(part) << line(1) << '\n' << line(2) << '\n' << line(3) << '\n' << "{\"frame\":4";
  KeptLines lines(file_);
  EXPECT_EQ(lines.count(), 3);
  lines.remove_parts();
  EXPECT_FALSE(fs::exists(part));
  EXPECT_EQ(lines.next(), line(1));
}

}  // namespace
}  // namespace throng::app::output_folder_test
