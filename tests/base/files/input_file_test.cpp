#include "engine/base/files/input_file.h"

#include <array>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "engine/base/text/size_text.h"
#include "tests/app/temporary_folder.h"

namespace throng::input_file_test {
namespace {

namespace fs = std::filesystem;

class InputFiles : public app::test::TemporaryFolder {
 protected:
  std::string complaint(const fs::path& file) {
    const auto text = read_text(file, "a .glb", 10);
    return text ? "" : text.error().message;
  }
  void put(const std::string& text) { std::ofstream(file_, std::ios::binary) << text; }

  const fs::path file_ = folder_ / "walk.glb";
};

TEST_F(InputFiles, AreReadWhole) {
  put(std::string("a\0b\n", 4));
  EXPECT_EQ(*read_text(file_, "a .glb", 4), std::string("a\0b\n", 4));
  EXPECT_EQ(read_file(file_, "a .glb", 4)->size(), 4U);
  EXPECT_EQ(map_file(file_, "a .glb")->bytes.size(), 4U);
  put("");
  EXPECT_EQ(*read_text(file_, "a .glb", 0), "");
  EXPECT_TRUE(map_file(file_, "a .glb")->bytes.empty());
}

TEST_F(InputFiles, AreReadThoughTheirSizeIsNotKnown) {
  EXPECT_THAT(*read_text("/proc/self/status", "a text", 1U << 20U), testing::HasSubstr("Pid:"));
}

TEST_F(InputFiles, GoOnWhereTheyAreToldTo) {
  put("0123456789");
  auto file = InputFile::open(file_);
  std::array<std::byte, 4> bytes{};
  ASSERT_TRUE(file && file->go_to(7));
  EXPECT_EQ(*file->read(bytes), 3U);
  EXPECT_EQ(bytes[0], std::byte{'7'});
}

TEST_F(InputFiles, LargerThanTheLimitAreRefused) {
  put(std::string(11, 'x'));
  EXPECT_EQ(complaint(file_), "it is larger than 10 B, the most for a .glb");
}

TEST_F(InputFiles, SayThatAPointerOfGitLfsStandsInTheirPlace) {
  put("version https://git-lfs.github.com/spec/v1\noid "
      "sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n");
  EXPECT_EQ(complaint(file_), "it is a pointer of Git LFS, not the file itself; run git lfs pull");
  EXPECT_FALSE(map_file(file_, "a .glb"));
  put("version https://git-lfs.example.com is another text, which is long enough");
  EXPECT_EQ(read_text(file_, "a text", 1000)->size(), 73U);
}

TEST_F(InputFiles, SayWhatLiesInTheirPlace) {
  EXPECT_EQ(complaint(file_), "there is no such file; check the path");
  EXPECT_EQ(complaint(file_ / "below"), "there is no such file; check the path");
  EXPECT_EQ(complaint(folder_), "it is a folder, not a file; name a .glb");
  EXPECT_EQ(complaint("/dev/zero"), "it is a device, not a file; name a .glb");
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  EXPECT_EQ(complaint(file_), "it is a pipe, not a file; name a .glb");
  fs::create_symlink("nowhere.glb", folder_ / "link.glb");
  EXPECT_EQ(complaint(folder_ / "link.glb"), "it is a link to nowhere.glb, which does not exist");
  fs::create_symlink("loop.glb", folder_ / "loop.glb");
  EXPECT_THAT(complaint(folder_ / "loop.glb"), testing::StartsWith("it cannot be read: "));
}

TEST(SizeText, IsInTheUnitThatPeopleExpect) {
  EXPECT_EQ(size_text(0), "0 B");
  EXPECT_EQ(size_text(1023), "1023 B");
  EXPECT_EQ(size_text(1536), "1.5 KiB");
  EXPECT_EQ(size_text(std::uint64_t{200} << 20U), "200 MiB");
  EXPECT_EQ(size_text(std::uint64_t{3} << 30U), "3.0 GiB");
}

}  // namespace
}  // namespace throng::input_file_test
