// Keys with Ctrl, Alt or Super held.
#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::hotkeys_test {
namespace {

struct Hotkeys : testing::Test {
  Requests press_with(Key modifier, Key key) {
    driver.hold(modifier);
    Requests requests = driver.press(key);
    driver.let_go(modifier);
    driver.frames();
    return requests;
  }
  OverlayDriver driver;
};

TEST_F(Hotkeys, MeanNothingOfTheirOwnInACombination) {
  driver.report.selected.emplace();
  for (const Key modifier : {Key::control, Key::alt, Key::super}) {
    for (const Key key : {Key::c, Key::r, Key::p, Key::l, Key::b, Key::x, Key::g, Key::space, Key::home, Key::escape}) {
      const Requests requests = press_with(modifier, key);
      EXPECT_EQ(requests.begin(), requests.end()) << static_cast<int>(key);
    }
  }
  press_with(Key::alt, Key::tab);
  EXPECT_FALSE(driver.overlay.ui_map().hidden) << "another window is chosen by it";
}

TEST_F(Hotkeys, CtrlQAsksToCloseTheWindowAlsoWhileAPersonTypes) {
  EXPECT_TRUE(asks<Quit>(press_with(Key::control, Key::q)));
  driver.type("/");
  ASSERT_TRUE(driver.overlay.ui_map().typing);
  EXPECT_TRUE(asks<Quit>(press_with(Key::control, Key::q)));
}

}  // namespace
}  // namespace throng::app::hotkeys_test
