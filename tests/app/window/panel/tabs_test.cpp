// The tabs with a memory of their own: scheduling, agent, presets; and the time of the crowd.
#include <string>

#include <gtest/gtest.h>

#include "app/settings/preset.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::tabs_test {
namespace {

SelectionReport an_agent() {
  SelectionReport selected{
      .agent = 7, .visible = true, .interval = 2, .can_fall = true, .channels = 1, .entities = {}, .clip_seconds = 2};
  selected.entities = {{.kind = "sampled player",
                        .clip = "Walking_A",
                        .fields = {{"Priority", "highest"}, {"Bones", "62"}},
                        .block = std::vector<std::uint8_t>(128, 0xAB)},
                       {.kind = "ease blender", .clip = {}, .fields = {{"Sources", "2"}}}};
  selected.layers = {{.name = "Channel 0", .entities = {0, 1}},
                     {.name = "look-at", .weight = 0.5F, .is_channel = false, .entities = {2}}};
  selected.history.assign(200, {.visible = true, .interval = 3, .bone_level = 1});
  selected.events = {"12.00 s  begins Idle"};
  return selected;
}

void scroll_down(OverlayDriver& driver) {
  driver.point_at(1100, 600);
  driver.frames();
  driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -100});
  driver.frames();
}

struct AgentTabTest : testing::Test {
  AgentTabTest() {
    driver.click("tab:Agent");
    driver.report.selected = an_agent();
    driver.frames();
  }
  OverlayDriver driver;
};

TEST_F(AgentTabTest, HasNothingToHoldWithoutASelection) {
  driver.report.selected.reset();
  driver.frames();
  EXPECT_FALSE(driver.sees("Hold clip at"));
  EXPECT_FALSE(driver.sees("LOD history"));
}

TEST_F(AgentTabTest, ShowsEachChannelWithItsEntitiesAndWhatChangesThePose) {
  for (const std::string row : {"Layer 0", "Layer 0, entity 0", "Layer 0, entity 1", "Layer 1"}) {
    EXPECT_TRUE(driver.sees(row)) << row;
  }
  EXPECT_FALSE(driver.sees("Layer 1, entity 2")) << "its own row says it";
  const int half = driver.overlay.vertex_count();
  driver.report.selected->layers[1].weight = 0;
  driver.frames();
  EXPECT_LT(driver.overlay.vertex_count(), half) << "a shorter figure, and no bar";
}

TEST_F(AgentTabTest, ShowsItsCharacterAlone) {
  EXPECT_TRUE(asks<ViewSelected>(driver.click("View alone")));
  EXPECT_FALSE(asks<ViewSelected>(driver.click("Layer 0")));
}

TEST_F(AgentTabTest, ShowsLevelOfDetailOverTheLastFrames) {
  EXPECT_TRUE(driver.sees("LOD history"));
  const int with_history = driver.overlay.vertex_count();
  driver.report.selected->history.clear();
  driver.frames();
  EXPECT_LT(driver.overlay.vertex_count(), with_history);
}

TEST_F(AgentTabTest, HoldsTheClipWhereItIsDraggedAndLetsGo) {
  EXPECT_FALSE(asks<Hold>(driver.click("Let go"))) << "nothing is held";
  driver.report.selected->held_at = 0.5F;
  driver.frames();
  EXPECT_FALSE(asked<Hold>(driver.click("Let go")).agent);
  EXPECT_EQ(asked<Push>(driver.click("Push")).agent, 7U);
  const auto held = asked<Hold>(driver.click("Hold clip at"));
  EXPECT_EQ(held.agent, 7U);
  EXPECT_NEAR(held.seconds, 1, 0.02) << "the middle of two seconds";
}

TEST_F(AgentTabTest, CannotHoldTheClipOfAnAgentThatPlaysNoneOrFalls) {
  driver.report.selected->posture = Posture::falling;
  driver.frames();
  EXPECT_FALSE(asks<Hold>(driver.click("Hold clip at")));
  driver.report.selected->posture = Posture::upright;
  driver.report.selected->clip_seconds = 0;
  driver.frames();
  EXPECT_FALSE(asks<Hold>(driver.click("Hold clip at")));
}

TEST_F(AgentTabTest, ShowsTheBlockOfThePoseFirstAndOfAnyEntityPicked) {
  scroll_down(driver);
  EXPECT_TRUE(driver.sees("Sources")) << "the last entity is the pose";
  EXPECT_FALSE(driver.sees("Priority"));
  driver.click("Entity");
  driver.click("Entity:0: sampled player, Walking_A");
  scroll_down(driver);
  EXPECT_TRUE(driver.sees("Bones"));
  EXPECT_TRUE(driver.sees("Block bytes"));
}

struct TimelineTest : testing::Test {
  TimelineTest() {
    driver.click("tab:Scheduling");
    scroll_down(driver);
  }
  void point_into_timeline(float share) {
    const UiRectangle place = *driver.find("Timeline");
    driver.point_at(place.x + share * place.width, place.y + place.height / 4);
    driver.frames();
  }
  OverlayDriver driver;
};

TEST_F(TimelineTest, ShowsEveryFrameThatThereIs) {
  const int two_frames = driver.overlay.vertex_count();
  driver.report.timeline.push_back(driver.report.timeline.front());
  driver.frames();
  EXPECT_GT(driver.overlay.vertex_count(), two_frames);
  driver.report.timeline.clear();
  driver.frames();
  EXPECT_FALSE(driver.sees("Timeline"));
}

TEST_F(TimelineTest, TheWheelZoomsAndDoesNotScrollTheTab) {
  ASSERT_TRUE(driver.sees("Timeline"));
  point_into_timeline(0.1F);
  const float y = driver.find("Timeline")->y;
  const int all = driver.overlay.vertex_count();
  driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = 10});
  driver.frames();
  EXPECT_EQ(driver.find("Timeline")->y, y);
  point_into_timeline(0.99F);  // away from the span that the pointer told of
  EXPECT_NE(driver.overlay.vertex_count(), all);
}

TEST_F(TimelineTest, ThePointerTellsWhatASpanWas) {
  point_into_timeline(0.99F);
  driver.point_at(450, 300);
  driver.frames();
  const int without = driver.overlay.vertex_count();
  point_into_timeline(0.3F);
  const int without_agents = driver.overlay.vertex_count();
  EXPECT_GT(without_agents, without);
  for (TimelineFrame& frame : driver.report.timeline) {
    for (auto& lane : frame.lanes) lane[1].content = {.first_agent = 12, .last_agent = 40, .agents = 16};
  }
  driver.frames();
  EXPECT_GT(driver.overlay.vertex_count(), without_agents) << "and for which agents";
}

struct PresetsTabTest : testing::Test {
  PresetsTabTest() { driver.click("tab:Presets"); }
  OverlayDriver driver;
};

TEST_F(PresetsTabTest, KeepsThemUnderNamesThatAFileCanHave) {
  EXPECT_FALSE(asks<SavePreset>(driver.click("Save preset"))) << "no name yet";
  driver.click("Name.field");
  driver.type("far crowd_2");
  driver.press(Key::enter);
  EXPECT_EQ(asked<SavePreset>(driver.click("Save preset")).preset, "far crowd_2");
  driver.report.preset_names = {"far crowd_2"};
  driver.frames();
  EXPECT_TRUE(driver.sees("Replace preset"));
  for (const char* const bad : {"", " ", "a/b", "..", "a.json", "tail "}) EXPECT_FALSE(can_name_a_preset(bad)) << bad;
}

TEST_F(PresetsTabTest, LoadsAndAfterAskingDeletes) {
  driver.report.preset_names = {"far", "near"};
  driver.frames();
  EXPECT_EQ(asked<LoadPreset>(driver.click("Load near")).preset, "near");
  EXPECT_FALSE(asks<DeletePreset>(driver.click("Delete far"))) << "asks first";
  EXPECT_FALSE(asks<DeletePreset>(driver.click("Delete near"))) << "that was the other one";
  EXPECT_EQ(asked<DeletePreset>(driver.click("Delete near")).preset, "near");
}

TEST_F(PresetsTabTest, CopiesTheCommandLine) {
  EXPECT_TRUE(asks<CopyCommandLine>(driver.click("Copy as command line")));
}

TEST(OverlayPanels, HaveNoGroundWhereTheCallerFillsIt) {
  OverlayDriver driver;
  driver.frames();
  const int with = driver.overlay.vertex_count();
  driver.overlay.leave_ground_out();
  driver.frames();
  EXPECT_EQ(driver.overlay.vertex_count(), with - 8) << "a rectangle of the column and one of the strip";
}

TEST(Tabs, FitIntoAWindowOfAnySize) {
  OverlayDriver driver;
  for (const std::string tab : {"Crowd", "LOD skipping", "Per-bone LOD", "Scheduling", "Agent", "Presets"}) {
    driver.click("tab:" + tab);
    for (int pixels = 1; pixels <= 700; ++pixels) {
      driver.overlay.begin_frame(pixels, 80, 1.0 / 60, {});
      driver.overlay.build(driver.report, driver.tuning);
      driver.overlay.begin_frame(900, pixels, 1.0 / 60, {});
      driver.overlay.build(driver.report, driver.tuning);
    }
    driver.frames(2);  // there is room for the next tab again
  }
}

TEST(CrowdTabTime, RewindsOnlyWhereThereIsAnEarlierMoment) {
  OverlayDriver driver;
  EXPECT_FALSE(asks<GoBack>(driver.click("Rewind")));
  driver.report.snapshots = {0.2F, 0.7F, 1.2F};
  driver.frames();
  EXPECT_EQ(asked<GoBack>(driver.click("Rewind")).moment, 0U);
}

TEST(CrowdTabTime, GoesBackToTheSnapshotNearestToWhereTheSliderIsLetGo) {
  OverlayDriver driver;
  driver.report.snapshots = {0.2F, 0.7F, 1.2F, 1.7F};
  driver.frames();
  const UiRectangle track = *driver.find("Back by");
  driver.point_at(track.x + 2, track.y + track.height / 2);
  const auto press = [&](bool down) { driver.input.push({.kind = InputEvent::Kind::button, .down = down}); };
  press(true);
  driver.point_at(track.x + 0.72F * track.width, track.y + track.height / 2);
  EXPECT_FALSE(asks<GoBack>(driver.frames())) << "still dragged";
  press(false);
  EXPECT_EQ(asked<GoBack>(driver.frames()).moment, 2U);
  EXPECT_FALSE(asks<GoBack>(driver.frames())) << "once";
}

TEST(FrameGraph, LooksAtTheFrameThatIsClickedAt) {
  OverlayDriver driver;
  driver.report.frame = 500;
  driver.report.kept.numbers = {390, 420};
  driver.frames();
  EXPECT_NEAR(asked<LookAtFrame>(driver.click("Frame graph")).frame, 380, 2) << "the middle of 240 frames";
  EXPECT_EQ(driver.overlay.ui_map().tab, "Scheduling");
}

TEST(FrameGraph, TheFrameThatIsLookedAtHasItsTableAndTimelineUntilOneGoesBack) {
  OverlayDriver driver;
  driver.click("tab:Scheduling");
  EXPECT_FALSE(driver.sees("Agents updated"));
  FrameDetails frame{.frame_ms = 80, .update_ms = 60, .work = {}, .pu = driver.report.pu, .timeline = {}};
  frame.timeline = driver.report.timeline.front();
  driver.report.kept = {.numbers = {1}, .looked_at = frame, .seconds_ago = 3.2F};
  driver.report.timeline.clear();
  driver.frames();
  for (const char* const part : {"Agents updated", "Tiles", "Copied in, out", "PU table", "Timeline"}) {
    EXPECT_TRUE(driver.sees(part)) << part;
  }
  EXPECT_TRUE(asks<LookAtLastFrames>(driver.click("Back to the last frames")));
}

TEST(DroppedFiles, AreOpenedTogetherAndOnce) {
  OverlayDriver driver;
  driver.input.push({.kind = InputEvent::Kind::file, .path = "a.glb"});
  driver.input.push({.kind = InputEvent::Kind::file, .path = "b.glb"});
  EXPECT_EQ(asked<OpenFiles>(driver.frames(1)).files, (std::vector<std::string>{"a.glb", "b.glb"}));
  EXPECT_FALSE(asks<OpenFiles>(driver.frames(1)));
}

TEST(UndoAndRedo, AreAskedForByKeysWithControl) {
  OverlayDriver driver;
  const auto expect_asked = [&driver](Key key, bool undo, bool redo) {
    const Requests requests = driver.press(key);
    EXPECT_EQ(asks<Undo>(requests), undo);
    EXPECT_EQ(asks<Redo>(requests), redo);
  };
  expect_asked(Key::z, false, false);
  expect_asked(Key::y, false, false);
  driver.hold(Key::control);
  expect_asked(Key::z, true, false);
  expect_asked(Key::y, false, true);
  driver.hold(Key::shift);
  expect_asked(Key::z, false, true);
}

TEST(UndoAndRedo, AreNotAskedForWhileTheUserTypesIntoAField) {
  OverlayDriver driver;
  driver.click("Agents.field");
  driver.hold(Key::control);
  EXPECT_FALSE(asks<Undo>(driver.press(Key::z)));
}

TEST(Changes, LastAsLongAsATrackIsDragged) {
  OverlayDriver driver;
  EXPECT_FALSE(driver.overlay.is_in_a_change());
  driver.point_at("Agents", 0.5F);
  driver.button(true);
  driver.point_at("Agents", 1);
  EXPECT_EQ(asked<Apply>(driver.frames()).tuning.agents, 100'000);
  EXPECT_TRUE(driver.overlay.is_in_a_change());
  driver.button(false);
  driver.frames();
  EXPECT_FALSE(driver.overlay.is_in_a_change());
}

}  // namespace
}  // namespace throng::app::tabs_test
