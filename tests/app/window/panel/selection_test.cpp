#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/show/camera/fly_camera.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::selection_test {
namespace {

SelectionReport an_agent() {
  SelectionReport selected{.agent = 1234,
                           .role = Role::walk,
                           .habit = Habit::stroll,
                           .visible = true,
                           .interval = 2,
                           .can_fall = true,
                           .channels = 1,
                           .entities = {},
                           .bytes = 384};
  selected.entities = {{.kind = "sampled player", .clip = "Walking_A", .duration_seconds = 1, .weight = 0.25F},
                       {.kind = "sampled player", .clip = "Idle", .duration_seconds = 2, .weight = 0.75F},
                       {.kind = "ease blender", .clip = {}, .weight = 1, .priority = -1}};
  return selected;
}

bool deselects(const Requests& requests) {
  const Select* const last = last_of<Select>(requests);
  return last != nullptr && !last->agent;
}

struct SelectionCard : testing::Test {
  OverlayDriver driver;

  Requests click_at(float x, float y, float moved = 0) {
    driver.point_at(x, y);
    driver.input.push({.kind = InputEvent::Kind::button, .down = true});
    driver.point_at(x + moved, y);
    driver.input.push({.kind = InputEvent::Kind::button, .down = false});
    return driver.frames();
  }
  void select() {
    driver.report.selected = an_agent();
    driver.frames();
  }
};

TEST_F(SelectionCard, ShowsTheSelectedAgentWithEachEntity) {
  EXPECT_FALSE(driver.sees("Selected"));
  select();
  EXPECT_TRUE(driver.sees("Selected"));
  for (const std::string row : {"Entity 0", "Entity 1", "Entity 2"}) EXPECT_TRUE(driver.sees(row)) << row;
  EXPECT_FALSE(driver.sees("Entity 3"));
  const UiRectangle card = *driver.find("Selected"), crowd = driver.overlay.crowd_area();
  EXPECT_LE(card.x + card.width, crowd.width);
  EXPECT_LE(card.y + card.height, crowd.height);
  driver.report.selected.reset();
  driver.frames();
  EXPECT_FALSE(driver.sees("Selected"));
}

TEST_F(SelectionCard, NamesEveryHabitHereAndInTheAgentTab) {
  driver.overlay.show_tab("agent");
  select();
  for (std::size_t habit = 0; habit < habit_words.size(); ++habit) {
    driver.report.selected->habit = static_cast<Habit>(habit);
    EXPECT_NO_THROW(driver.frames()) << habit_words.at(habit);
    EXPECT_TRUE(driver.sees("Selected"));
  }
}

TEST_F(SelectionCard, OfALongGraphShowsTheEndAndStaysInThePicture) {
  driver.shown_height = 1300;  // which 64 entities do not fit
  select();
  driver.report.selected->entities.resize(64);
  driver.frames();
  EXPECT_FALSE(driver.sees("Entity 47"));
  EXPECT_TRUE(driver.sees("Entity 62"));
  EXPECT_TRUE(driver.sees("Entity 63"));
  const UiRectangle card = *driver.find("Selected"), crowd = driver.overlay.crowd_area();
  EXPECT_LE(card.width * card.height, crowd.width * crowd.height / 5);
}

TEST_F(SelectionCard, AClickAtTheCrowdAsksForTheAgentThere) {
  const PicturePoint point = asked<SelectAt>(click_at(300, 200)).point;
  EXPECT_EQ(point.x, 300);
  EXPECT_EQ(point.y, 200);
}

TEST_F(SelectionCard, ADragAndAClickAtTheOverlayAreNoClicksAtTheCrowd) {
  EXPECT_FALSE(asks<SelectAt>(click_at(300, 200, 40))) << "a drag";
  EXPECT_TRUE(asks<SelectAt>(click_at(300, 200, 2))) << "a hand is not quite still";
  EXPECT_FALSE(asks<SelectAt>(click_at(1100, 300))) << "the column";
  EXPECT_FALSE(asks<SelectAt>(click_at(300, OverlayDriver::height - 70))) << "the strip";
  select();
  const UiRectangle card = *driver.find("Selected");
  EXPECT_FALSE(asks<SelectAt>(click_at(card.x + 20, card.y + 20))) << "the card";
  driver.point_at(1100, 300);
  driver.input.push({.kind = InputEvent::Kind::button, .down = true});
  driver.point_at(300, 200);
  driver.input.push({.kind = InputEvent::Kind::button, .down = false});
  EXPECT_FALSE(asks<SelectAt>(driver.frames())) << "pressed at the overlay";
}

TEST_F(SelectionCard, EscapeDeselectsFirstAndQuitsThen) {
  select();
  const Requests first = driver.press(Key::escape);
  EXPECT_TRUE(deselects(first));
  EXPECT_FALSE(asks<Quit>(first));
  driver.report.selected.reset();
  EXPECT_TRUE(asks<Quit>(driver.press(Key::escape)));
}

TEST_F(SelectionCard, StaysWhileEscapeClosesTheHelpAboveIt) {
  select();
  driver.press(Key::f1);
  ASSERT_TRUE(driver.overlay.ui_map().help);
  const Requests first = driver.press(Key::escape);
  EXPECT_FALSE(asks<Select>(first) || asks<Quit>(first));
  EXPECT_FALSE(driver.overlay.ui_map().help);
  EXPECT_TRUE(deselects(driver.press(Key::escape)));
}

TEST_F(SelectionCard, PushesOverByItsButtonAndByP) {
  EXPECT_FALSE(asks<Push>(driver.press(Key::p))) << "no agent is selected";
  select();
  driver.report.camera.yaw = 90;
  for (const Push& push : {asked<Push>(driver.click("Push over")), asked<Push>(driver.press(Key::p))}) {
    EXPECT_EQ(push.agent, 1234U);
    EXPECT_EQ(push.direction, render::forward(camera_at(driver.report.camera))) << "it falls away from the camera";
  }
  EXPECT_TRUE(deselects(driver.click("Deselect")));
  EXPECT_TRUE(deselects(driver.click("Selected.close")));
  driver.report.selected->can_fall = false;
  driver.frames();
  EXPECT_FALSE(asks<Push>(driver.click("Push over"))) << "nothing in it could fall";
}

TEST_F(SelectionCard, IsInTheMapAsTheReportHasIt) {
  const auto selected_in_map = [&] {
    const auto map = nlohmann::json::parse(to_json(driver.overlay.ui_map(), driver.tuning, driver.report));
    return map["report"]["selected"];
  };
  EXPECT_TRUE(selected_in_map().is_null());
  select();
  const auto selected = selected_in_map();
  EXPECT_EQ(selected["agent"], 1234);
  EXPECT_EQ(selected["bytes"], 384);
  EXPECT_EQ(selected["posture"], "upright");
  EXPECT_EQ(selected["entities"][1]["clip"], "Idle");
  EXPECT_EQ(selected["entities"][1]["weight"], 0.75);
}

TEST_F(SelectionCard, MemoryByKindIsInTheSchedulingTab) {
  driver.click("tab:Scheduling");
  const auto scroll_down = [&] {
    driver.point_at(1100, 400);
    driver.frames();
    driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -100});
    driver.frames();
  };
  scroll_down();
  EXPECT_FALSE(driver.sees("ease blender"));
  driver.report.memory = {
      {.kind = "sampled player", .own = {.blocks_alive = 1000, .bytes_alive = 128000}, .shared = {}},
      {.kind = "ease blender", .own = {}, .shared = {.blocks_alive = 12, .bytes_alive = 1536}},
      {.kind = "look-at", .own = {}, .shared = {}}};
  driver.frames();
  scroll_down();
  EXPECT_TRUE(driver.sees("sampled player"));
  EXPECT_TRUE(driver.sees("ease blender"));
  EXPECT_FALSE(driver.sees("look-at")) << "it has no blocks";
}

}  // namespace
}  // namespace throng::app::selection_test
