// A window of any size shows the whole picture of that size, and is clicked where it shows.
#include <string>
#include <vector>

#include "app/output/regression/compare.h"
#include "tests/window/display_scale.h"
#include "tests/window/screen.h"
#include "tests/window/window_driver.h"

namespace throng::app::window_size_test {
namespace {

using Json = nlohmann::json;

/// Means over a picture, in steps of 255. The figures of the overlay and what the pointer is over differ by less from
/// one frame to the next; a picture that slid or was cut off differs by more than ten.
constexpr double largest_mean_difference = 1.5;

class WindowSize : public WindowDriver {
 protected:
  /// The picture keeps its cost, so that two frames of a still crowd are equal.
  std::vector<std::string> options() const override {
    return {"--agents", "50", "--size", "1280x720", "--set", "holds_rate=off"};
  }
  void SetUp() override {
    WindowDriver::SetUp();
    point_at_the_corner();
  }
  // No row explains itself there, and keys still reach the window.
  void point_at_the_corner() { point_at(2, 2); }
  void window(const std::vector<std::string>& words) {
    std::vector<std::string> command{"search", "--name", "^Throng$"};
    command.insert(command.end(), words.begin(), words.end());
    xdotool(command);
  }
  void resize(glm::ivec2 size) {
    window({"windowsize", std::to_string(size.x), std::to_string(size.y)});
    wait_for("its new size", [&](const Json& map) { return map["size"] == Json::array({size.x, size.y}); });
    next_map();
  }
  void pause() {
    press("space");
    wait_for("a pause", [](const Json& map) { return map["tuning"]["paused"].get<bool>(); });
  }
  std::string take_picture() {
    press("F12");
    const std::string file = "throng-" + std::to_string(++pictures_) + ".png";
    wait_for_message("Wrote " + (folder() / file).string());
    return file;
  }
  /// Holds what the display shows against the picture that was drawn.
  void expect_that_it_shows_its_picture(glm::ivec2 size) {
    take_picture();  // the notice of this one is on both of the next
    const std::string file = take_picture();
    if (next_map()["widgets"].contains("message:1")) click("message:0");  // the notice of the second
    point_at_the_corner();
    next_map();
    const auto drawn = render::read_png(folder() / file);
    const auto shown = picture_of_screen(display(), size);
    ASSERT_TRUE(drawn && shown) << file;
    const auto difference = measure_difference(*drawn, *shown);
    ASSERT_TRUE(difference) << file << ": " << difference.error().message;
    EXPECT_LT(difference->mean, largest_mean_difference) << size.x << "x" << size.y;
  }
  void expect_that_it_is_clicked_where_it_shows() {
    for (const std::string tab : {"Scheduling", "Presets", "Crowd"}) {
      click("tab:" + tab);
      wait_for(tab, [&](const Json& map) { return map["tab"] == tab; });
    }
  }

 private:
  int pictures_ = 0;
};

TEST_F(WindowSize, MayBeAnyAndShowsAndTakesClicksWhereItShows) {
  pause();
  for (const glm::ivec2 size : {glm::ivec2(1280, 720), {1100, 700}, {640, 480}, {1380, 880}, {801, 603}, {1280, 720}}) {
    ASSERT_NO_FATAL_FAILURE(resize(size));
    ASSERT_NO_FATAL_FAILURE(expect_that_it_shows_its_picture(size));
    ASSERT_NO_FATAL_FAILURE(expect_that_it_is_clicked_where_it_shows());
  }
}

TEST_F(WindowSize, IsAsBeforeAfterTheWindowWasHidden) {
  pause();
  window({"windowunmap"});
  window({"windowmap"});
  next_map();
  expect_that_it_shows_its_picture({1280, 720});
}

TEST_F(WindowSize, IsThatOfTheScreenAfterF11AndAsBeforeAfterAltEnter) {
  const auto wait_for_size = [&](glm::ivec2 size) {
    wait_for("its size", [&](const Json& map) { return map["size"] == Json::array({size.x, size.y}); });
  };
  press("F11");
  wait_for_size(screen());
  xdotool({"key", "alt+Return"});
  wait_for_size({1280, 720});
}

TEST_F(WindowSize, HasAPanelOfTheScaleOfItsDisplayUnlessAnotherIsAskedFor) {
  const auto height_of_search = [&] { return next_map()["widgets"]["search"]["h"].get<double>(); };
  const double usual = height_of_search();
  const auto display_of_many_dots = with_dots_per_inch(display(), 144);
  start_program(options());
  EXPECT_GT(height_of_search(), 1.3 * usual);
  std::vector<std::string> plain = options();
  plain.insert(plain.end(), {"--ui-scale", "1"});
  start_program(plain);
  EXPECT_EQ(height_of_search(), usual);
}

TEST_F(WindowSize, HasAPanelAsWideAsItWasLeft) {
  const auto edge = [&] { return next_map()["widgets"]["panel edge"]["x"].get<double>(); };
  point_at(edge() + 2, 300);
  button(1, true);
  point_at(700, 300);
  next_map();
  button(1, false);
  EXPECT_NEAR(edge(), 700, 3);
  xdotool({"key", "ctrl+q"});
  ASSERT_EQ(program().exit_status(soon()), 0);
  start_program(options());
  EXPECT_NEAR(edge(), 700, 3);
}

class LargeOverlay : public WindowSize {
 protected:
  std::vector<std::string> options() const override {
    return {"--agents", "50", "--size", "1280x720", "--set", "holds_rate=off", "--ui-scale", "2"};
  }
};

TEST_F(LargeOverlay, IsClickedWhereItShowsInEverySize) {
  pause();
  for (const glm::ivec2 size : {glm::ivec2(1280, 720), {1000, 800}, {1380, 880}}) {
    ASSERT_NO_FATAL_FAILURE(resize(size));
    ASSERT_NO_FATAL_FAILURE(expect_that_it_shows_its_picture(size));
    ASSERT_NO_FATAL_FAILURE(expect_that_it_is_clicked_where_it_shows());
  }
}

}  // namespace
}  // namespace throng::app::window_size_test
