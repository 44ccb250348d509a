#include "engine/base/files/folder_entries.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/temporary_folder.h"

namespace throng::folder_entries_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

using FolderEntries = app::test::TemporaryFolder;

std::vector<std::string> names(const std::vector<FolderEntry>& entries) {
  std::vector<std::string> all;
  for (const FolderEntry& entry : entries) all.push_back(entry.name + (entry.is_folder ? "/" : ""));
  return all;
}

TEST_F(FolderEntries, AreFoldersThenFilesByNameWithoutHiddenOnesAndDeadLinks) {
  for (const char* const name : {"b.txt", "a.txt", ".hidden"}) std::ofstream(folder_ / name) << "text";
  fs::create_directory(folder_ / "z");
  fs::create_directory_symlink(folder_ / "z", folder_ / "link");
  fs::create_symlink(folder_ / "nowhere", folder_ / "dead");
  const auto entries = folder_entries(folder_);
  ASSERT_TRUE(entries);
  EXPECT_THAT(names(*entries), ElementsAre("link/", "z/", "a.txt", "b.txt"));
}

TEST_F(FolderEntries, OfNoFolderAreAnErrorThatNamesIt) {
  const auto entries = folder_entries(folder_ / "nowhere");
  ASSERT_FALSE(entries);
  EXPECT_THAT(entries.error().message, HasSubstr("nowhere: the folder cannot be read: No such file"));
}

}  // namespace
}  // namespace throng::folder_entries_test
