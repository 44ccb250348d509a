#include <string>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/camera/camera_path.h"
#include "tests/tracks/track_file.h"

namespace throng::app::keyed_path_test {
namespace {

using testing::HasSubstr;

const std::string header = "time,x,y,z,yaw,pitch,fov\n";

class KeyedPath : public testing::Test {
 protected:
  Result<std::vector<CameraKey>> read(const std::string& text) const {
    return read_camera_keys(folder_.file("path.csv", text));
  }
  std::string refusal(const std::string& text) const {
    const auto keys = read(text);
    return keys ? std::string() : keys.error().message;
  }
  const TrackFolder folder_;
};

TEST_F(KeyedPath, PassesEveryKeyAndStandsStillAtItsEnds) {
  const auto keys = read(header + "1,0,2,5,350,0,50\n3,4,2,5,10,-10,50\n\n4,8,3,5,20,-10,30\n");
  ASSERT_TRUE(keys);
  EXPECT_EQ(along(*keys, 0.0), along(*keys, 1.0));
  EXPECT_EQ(along(*keys, 3.0).position, glm::vec3(4.0F, 2.0F, 5.0F));
  EXPECT_EQ(along(*keys, 9.0).position, glm::vec3(8.0F, 3.0F, 5.0F));
  EXPECT_NEAR(along(*keys, 9.0).vertical_view, glm::radians(30.0F), 1e-5F);
  EXPECT_NEAR(along(*keys, 2.0).yaw, glm::radians(359.0F), 0.1F) << "by the shorter way";
  for (double seconds = 0.0; seconds < 5.0; seconds += 0.01) {
    EXPECT_LT(glm::distance(along(*keys, seconds).position, along(*keys, seconds + 0.01).position), 0.07F);
  }
}

TEST_F(KeyedPath, IsATableAsTrajectoriesAre) {
  for (const char* const text :
       {"\xEF\xBB\xBFtime,x,y,z,yaw,pitch\r\n0,0.5,2,9,0,0\r\n1,0,2,9,20,0\r\n",
        "sep=;\n\"time\";\"x\";\"y\";\"z\";\"yaw\";\"pitch\"\n0;0,5;2;9;0;0\n% a comment\n1;0;2;9;20;0\n",
        "# a comment\ntime x y z yaw pitch\n0 0.5 2 9 0 0\n\n1 0 2 9 20 0"}) {
    const auto keys = read(text);
    ASSERT_TRUE(keys) << keys.error().message;
    ASSERT_EQ(keys->size(), 2U) << text;
    EXPECT_EQ(keys->front().place.x, 0.5F) << text;
    EXPECT_EQ(keys->back().place.yaw, 20.0F) << text;
  }
  EXPECT_THAT(refusal("time,x,y,z,yaw,pitch\r0,0,2,9,0,0\r"), HasSubstr("its lines end with a carriage return alone"));
}

TEST_F(KeyedPath, NamesTheLineThatIsWrong) {
  EXPECT_THAT(refusal("0,0,0,0,0,0\n"), HasSubstr("path.csv: line 1: it is no header of a camera path"));
  EXPECT_THAT(refusal(header + "0,0,0,0,0,0\n1,a,0,0,0,0\n"), HasSubstr("path.csv: line 3: it is no key"));
  EXPECT_THAT(refusal(header + "1,0,0,0,0,0\n1,0,0,0,0,0\n"), HasSubstr("line 3: its time is not after"));
  EXPECT_THAT(refusal(header), HasSubstr("path.csv: it has no key"));
  EXPECT_FALSE(read_camera_keys(folder_.path("none.csv")));
}

}  // namespace
}  // namespace throng::app::keyed_path_test
