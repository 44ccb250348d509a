// A recorded crowd in the window: the user goes to any of its moments, both ways, and looks at one person.
#include <fstream>
#include <string>
#include <vector>

#include "tests/window/window_driver.h"

namespace throng::app::tracks_test {
namespace {

using Json = nlohmann::json;

/// Two people who pass each other in 20 s, one of them at the end alone.
class TracksInTheWindow : public WindowDriver {
 protected:
  std::vector<std::string> options() const override {
    const std::string file = (folder() / "walk.csv").string();
    std::ofstream rows(file);
    rows << "id,time,x,y\n";
    for (int row = 0; row <= 200; ++row) {
      rows << "7," << 0.1 * row << ',' << 0.02 * (row - 100) << ",0\n";
      if (row <= 100) rows << "8," << 0.1 * row << ',' << 0.1 * (50 - row) << ",1.5\n";
    }
    return {"--trajectories", file, "--camera", "0,1.6,6,0,-8,60", "--size", "1280x720"};
  }
  Json wait_for_tracks(const std::string& what, const std::function<bool(const Json&)>& holds) {
    return wait_for(what, [&](const Json& map) {
      return !map["report"]["tracks"].is_null() && holds(map["report"]["tracks"]);
    })["report"]["tracks"];
  }
  double seconds() { return next_map()["report"]["tracks"]["seconds"]; }
};

TEST_F(TracksInTheWindow, GoToAnyTimeBothWaysAndRowByRow) {
  press("space");
  wait_for("a pause", [](const Json& map) { return map["tuning"]["paused"] == true; });
  const double paused = seconds();
  EXPECT_EQ(seconds(), paused) << "the clock stands";
  drag("Tracks.track", 0.75);
  wait_for_tracks("15 s", [](const Json& tracks) { return std::abs(tracks["seconds"].get<double>() - 15.0) < 0.2; });
  EXPECT_EQ(next_map()["report"]["tracks"]["people"], 1);
  const double before = seconds();
  press("Right");
  wait_for_tracks("the next row", [&](const Json& tracks) { return tracks["seconds"] > before; });
  press("Left");
  press("Left");
  wait_for_tracks("a row back", [&](const Json& tracks) { return tracks["seconds"] < before; });
  click("Tracks.backwards");
  wait_for_tracks("less time", [&](const Json& tracks) { return tracks["seconds"] < 14.0 && tracks["rate"] == -1.0; });
  press("shift+space");
  wait_for_tracks("more time", [&](const Json& tracks) { return tracks["rate"] == 1.0; });
}

TEST_F(TracksInTheWindow, PlayAPartAgainAndAgain) {
  click("Tracks.faster");
  click("Tracks.faster");
  click("Tracks.faster");
  drag_to("Tracks.to", "Tracks.track");
  wait_for_tracks("an end", [](const Json& tracks) { return std::abs(tracks["last"].get<double>() - 10.0) < 1.0; });
  wait_for_tracks("8 s", [](const Json& tracks) { return tracks["seconds"] > 7.0 && tracks["rate"] == 8.0; });
  wait_for_tracks("its beginning", [](const Json& tracks) { return tracks["seconds"] < 4.0; });
  press("bracketleft");
  const Json part = wait_for_tracks("a part", [](const Json& tracks) { return tracks["first"] > 0.0; });
  wait_for_tracks("it alone", [&](const Json& tracks) { return tracks["seconds"] >= part["first"]; });
  click("Tracks.whole");
  wait_for_tracks("the whole", [](const Json& tracks) { return tracks["first"] == 0.0 && tracks["last"] == 20.0; });
}

TEST_F(TracksInTheWindow, ShowAPersonThatIsClickedAtOverTheWholeTime) {
  press("space");
  drag("Tracks.track", 0.5);
  wait_for_tracks("10 s", [](const Json& tracks) { return std::abs(tracks["seconds"].get<double>() - 10.0) < 0.2; });
  click_at({0.0F, 1.1F, 0.0F});
  const Json map = wait_for("the person", [](const Json& now) {
    return !now["report"]["selected"].is_null() && now["widgets"].contains("Selected.speed");
  });
  EXPECT_EQ(map["report"]["selected"]["tracked"]["id"], "7");
  EXPECT_GT(map["report"]["selected"]["tracked"]["footfalls"], 4);
  drag("Selected.speed", 0.25);
  wait_for_tracks("5 s", [](const Json& tracks) { return std::abs(tracks["seconds"].get<double>() - 5.0) < 0.3; });
  EXPECT_FALSE(next_map()["report"]["selected"].is_null());
}

TEST_F(TracksInTheWindow, AreNotRecordedWhichIsSaid) {
  press("r");
  wait_for_message("the scene tracks is not recorded");
  EXPECT_FALSE(std::filesystem::exists(folder() / "throng-1.rec"));
}

}  // namespace
}  // namespace throng::app::tracks_test
