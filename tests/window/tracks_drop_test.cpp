#include <fstream>
#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::tracks_drop_test {
namespace {

using Json = nlohmann::json;

class DroppedTracks : public WindowDriver {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    const std::string path = (folder() / name).string();
    std::ofstream(path) << text;
    return path;
  }
  /// A table in which some people walk to the right, until the end of an hour.
  std::string table(const std::string& name, int people) const {
    std::string text = "id,time,x,y\n";
    for (int person = 0; person < people; ++person) {
      for (const int seconds : {0, 3600}) {
        text += std::to_string(person) + "," + std::to_string(seconds) + "," + std::to_string(seconds / 360) + "," +
                std::to_string(person) + "\n";
      }
    }
    return file(name, text);
  }
  Json wait_for_people(int people) {
    return wait_for("the recorded crowd", [people](const Json& now) {
      return now["tuning"]["scene"] == "tracks" && now["report"]["agents"] == people && now["report"]["drawn"] > 0;
    });
  }
};

TEST_F(DroppedTracks, AreShownInPlaceOfTheCrowdAndOfEachOther) {
  drop(table("walk.csv", 7));
  wait_for_people(7);
  drop(table("more.csv", 9));
  wait_for_people(9);
  drop(file("hall.wkt", "POLYGON ((-2 -2, 12 -2, 12 12, -2 12, -2 -2))\n"));
  wait_for_message("Opened " + (folder() / "more.csv").string());
  wait_for_people(9);
}

TEST_F(DroppedTracks, ThatAreWrongChangeNothingAndAreNamed) {
  drop(file("walk.csv", "id,time,x,y\n1,0,0,0\n1,1,far,0\n"));
  const Json map = wait_for_message("line 3: \"far\" is not a number");
  EXPECT_EQ(map["report"]["agents"], 50);
  EXPECT_GT(next_map(5)["report"]["drawn"], 0);
}

TEST_F(DroppedTracks, GoOnAtTheirMomentWithOtherCharacters) {
  drop(table("walk.csv", 7));
  wait_for_people(7);
  const std::string model = std::string(THRONG_SOURCE_DIR) + "/tests/data/features/plain.glb";
  drop(model);
  wait_for("the new character", [&](const Json& now) {
    return now["report"]["characters"] == Json::array({model}) && now["report"]["agents"] == 7;
  });
}

}  // namespace
}  // namespace throng::app::tracks_drop_test
