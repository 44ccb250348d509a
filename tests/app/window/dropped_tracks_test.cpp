#include "app/window/dropped_tracks.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracks/track_file.h"

namespace throng::app::dropped_tracks_test {
namespace {

using testing::HasSubstr;

class DroppedTrackFiles : public testing::Test {
 protected:
  const TrackFolder folder_;
  const std::string table_ = folder_.file("walk.csv", "id,time,x,y\n1,0,0,0\n1,1,1,0\n");
  const std::string other_table_ = folder_.file("run.txt", "# framerate: 10\n1 0 0 0\n");
  const std::string walls_ = folder_.file("hall.wkt", "LINESTRING (0 0, 9 0)\n");
  const std::string model_ = std::string(THRONG_SOURCE_DIR) + "/assets/mannequin.glb";

  static std::string refusal(const std::vector<std::string>& files, const std::string& shown = {}) {
    const auto asked = tracks_to_read(files, shown);
    return asked ? std::string() : asked.error().message;
  }
};

TEST_F(DroppedTrackFiles, ThatAreModelsAreLeftToOthers) {
  const std::vector<std::string> files{model_, std::string(THRONG_SOURCE_DIR) + "/README.md"};
  const auto asked = tracks_to_read(files, table_);
  ASSERT_TRUE(asked);
  EXPECT_FALSE(*asked);
}

TEST_F(DroppedTrackFiles, AreATableAndTheWallsBesideIt) {
  const std::vector<std::string> files{walls_, table_};
  const auto asked = tracks_to_read(files, {});
  ASSERT_TRUE(asked && *asked);
  EXPECT_EQ((*asked)->file, table_);
  EXPECT_EQ((*asked)->walls, walls_);
}

TEST_F(DroppedTrackFiles, AreWallsOfTheCrowdThatIsShown) {
  const std::vector<std::string> files{walls_};
  const auto asked = tracks_to_read(files, table_);
  ASSERT_TRUE(asked && *asked);
  EXPECT_EQ((*asked)->file, table_);
  EXPECT_THAT(refusal(files), HasSubstr("drop its file together with them"));
}

TEST_F(DroppedTrackFiles, AreRefusedWhereTheyDoNotGoTogether) {
  EXPECT_THAT(refusal({table_, other_table_}), HasSubstr("run.txt: one recorded crowd is shown at a time"));
  EXPECT_THAT(refusal({table_, walls_, walls_}), HasSubstr("hall.wkt: one file of walls"));
  EXPECT_THAT(refusal({model_, table_}), HasSubstr("mannequin.glb: is no file of trajectories; drop it before"));
}

}  // namespace
}  // namespace throng::app::dropped_tracks_test
