#include "app/files/data_folder.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::data_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(DataFolder, TriesTheOptionTheEnvironmentTheInstallationAndTheSource) {
  setenv("THRONG_DATA", "from-environment", 1);
  const auto folders = data_folders("from-option");
  unsetenv("THRONG_DATA");
  ASSERT_THAT(folders, testing::SizeIs(4));
  EXPECT_EQ(folders[0], "from-option");
  EXPECT_EQ(folders[1], "from-environment");
  EXPECT_THAT(folders[2].string(), testing::EndsWith("/share/throng"));
  EXPECT_EQ(folders[3], THRONG_SOURCE_DIR);
}

TEST(DataFolder, LeavesOutWhatIsNotSaid) {
  unsetenv("THRONG_DATA");
  EXPECT_THAT(data_folders(""), testing::SizeIs(2));
}

TEST(FindData, TakesTheFirstFolderThatHasTheName) {
  const auto found = find_data({"no-such-folder", THRONG_SOURCE_DIR, "another"}, "app/files/data_folder.h");
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, fs::path(THRONG_SOURCE_DIR) / "app/files/data_folder.h");
}

TEST(FindData, ListsThePlacesTried) {
  const auto found = find_data({"here", "there"}, "assets/nobody.glb");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().message,
            "assets/nobody.glb: not found in here, there; --data DIR names the folder that has it");
}

}  // namespace
}  // namespace throng::app::data_folder_test
