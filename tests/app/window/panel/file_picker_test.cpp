// A person chooses a file to open, or a name to save the crowd under.
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/temporary_folder.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::file_picker_test {
namespace {

using testing::ElementsAre;

class PickedFile : public test::TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    std::filesystem::create_directory(folder_ / "models");
    for (const char* const name : {"fox.glb", "notes.docx", "mine.throng", "models/wolf.glb"}) write(name, "{}");
    write("walk.csv", "id,time,x,y\n1,0,0,0\n");
  }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  Requests press_control(Key key) {
    driver.hold(Key::control);
    Requests requests = driver.press(key);
    driver.let_go(Key::control);
    driver.frames();
    return requests;
  }
  void go_to_folder() {
    driver.type(folder_.string());
    driver.press(Key::enter);
  }
  void begin_to_open() {
    press_control(Key::o);
    go_to_folder();
  }
  void begin_to_save() {
    press_control(Key::s);
    go_to_folder();
  }
  bool is_open() const { return driver.sees("picker:field"); }

  OverlayDriver driver;
};

TEST_F(PickedFile, IsOneThatTheProgramCanOpenOrLiesInAFolder) {
  begin_to_open();
  for (const char* const name : {"..", "models", "fox.glb", "mine.throng", "walk.csv"}) {
    EXPECT_TRUE(driver.sees(std::string("picker:") + name)) << name;
  }
  EXPECT_FALSE(driver.sees("picker:notes.docx"));
  driver.click("picker:models");
  EXPECT_THAT(asked<OpenFiles>(driver.click("picker:wolf.glb")).files, ElementsAre(path("models/wolf.glb")));
  EXPECT_FALSE(is_open());
}

TEST_F(PickedFile, IsFoundByLettersOfItsName) {
  begin_to_open();
  driver.type("WAL");
  EXPECT_FALSE(driver.sees("picker:fox.glb"));
  EXPECT_THAT(asked<OpenFiles>(driver.press(Key::enter)).files, ElementsAre(path("walk.csv")));
}

TEST_F(PickedFile, IsWalkedToByKeys) {
  begin_to_open();
  for (int row = 0; row < 2; ++row) driver.press(Key::down);
  driver.press(Key::enter);
  EXPECT_TRUE(driver.sees("picker:wolf.glb")) << "the second row is a folder";
  driver.press(Key::backspace);
  EXPECT_TRUE(driver.sees("picker:fox.glb")) << "the folder above";
  for (int row = 0; row < 3; ++row) driver.press(Key::down);
  EXPECT_THAT(asked<OpenFiles>(driver.press(Key::enter)).files, ElementsAre(path("fox.glb")));
}

TEST_F(PickedFile, LiesInTheFolderOfAPathThatIsTyped) {
  press_control(Key::o);
  driver.type(path("models/wo"));
  driver.frames();
  EXPECT_TRUE(driver.sees("picker:wolf.glb"));
  EXPECT_FALSE(driver.sees("picker:fox.glb")) << "that is another folder";
  EXPECT_THAT(asked<OpenFiles>(driver.press(Key::enter)).files, ElementsAre(path("models/wolf.glb")));
}

TEST_F(PickedFile, IsReachedUpwardsFromTheWorkingFolder) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_ / "models");
  press_control(Key::o);
  driver.click("picker:..");
  EXPECT_TRUE(driver.sees("picker:fox.glb"));
  std::filesystem::current_path(before);
}

TEST_F(PickedFile, MayBeOneOfBefore) {
  driver.report.recent_files = {path("models/wolf.glb")};
  press_control(Key::o);
  const auto requests = driver.click("picker:" + path("models/wolf.glb"));
  EXPECT_THAT(asked<OpenFiles>(requests).files, ElementsAre(path("models/wolf.glb")));
}

TEST_F(PickedFile, HasToBeThere) {
  begin_to_open();
  driver.type(path("nobody.glb"));
  EXPECT_FALSE(asks<OpenFiles>(driver.press(Key::enter)));
  EXPECT_TRUE(is_open()) << "another can be named";
}

TEST_F(PickedFile, IsReplacedOnlyWhenThatIsAskedForOnceMore) {
  begin_to_save();
  EXPECT_FALSE(driver.sees("picker:fox.glb")) << "a crowd is saved in crowd files";
  driver.type("mine");
  EXPECT_FALSE(asks<SaveCrowd>(driver.press(Key::enter)));
  EXPECT_EQ(asked<SaveCrowd>(driver.press(Key::enter)).crowd, path("mine"));
}

TEST_F(PickedFile, GetsTheEndingOfACrowd) {
  begin_to_save();
  driver.type("other");
  EXPECT_EQ(asked<SaveCrowd>(driver.click("picker:take")).crowd, path("other"));
}

TEST_F(PickedFile, IsNotNeededToSaveACrowdThatHasOneUnlessANewOneIsAskedFor) {
  driver.report.crowd = "mine";
  EXPECT_EQ(asked<SaveCrowd>(press_control(Key::s)).crowd, "mine");
  EXPECT_FALSE(is_open());
  driver.hold(Key::shift);
  press_control(Key::s);
  EXPECT_TRUE(is_open());
}

TEST_F(PickedFile, LeavesEverythingBelowAlone) {
  driver.point_at(300, 300);
  begin_to_open();
  driver.type("pf");
  for (const Key key : {Key::p, Key::f, Key::tab}) EXPECT_FALSE(asks<FrameCrowd>(driver.press(key)));
  EXPECT_FALSE(driver.overlay.ui_map().hidden);
  EXPECT_TRUE(driver.overlay.uses_pointer() && driver.overlay.uses_keyboard());
  EXPECT_FALSE(asks<Quit>(driver.press(Key::escape)));
  EXPECT_FALSE(is_open());
  EXPECT_TRUE(asks<Quit>(driver.press(Key::escape)));
}

TEST_F(PickedFile, IsNoneWhileAReplayRuns) {
  driver.report.replay.emplace();
  press_control(Key::o);
  EXPECT_FALSE(is_open());
}

}  // namespace
}  // namespace throng::app::file_picker_test
