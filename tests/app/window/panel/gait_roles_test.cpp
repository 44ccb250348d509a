// The roles in the panel that only trajectories ask for.

#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::gait_roles_test {
namespace {

TEST(GaitRoles, AreShownWhenAskedForAndHiddenAgain) {
  OverlayDriver driver;
  const auto scroll = [&](float notches) {
    driver.point_at(1100, 400);
    driver.frames();
    driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = notches});
    driver.frames();
  };
  scroll(-100);
  EXPECT_FALSE(driver.sees("Step left"));
  ASSERT_TRUE(driver.sees("Show gaits"));
  driver.click("Show gaits");
  scroll(-100);
  for (const char* const role :
       {"Walk back", "Step left", "Step right", "Shuffle", "Step in place", "Veer left", "Veer right"}) {
    EXPECT_TRUE(driver.sees(role)) << role;
  }
  driver.click("Step left");
  const ViewRequest picked = asked<View>(driver.click("Step left:Running_A")).what;
  ASSERT_TRUE(picked.preview);
  EXPECT_EQ(picked.preview->role, Role::step_left);
  ASSERT_TRUE(driver.sees("Hide gaits"));
  driver.click("Hide gaits");
  EXPECT_FALSE(driver.sees("Step left"));
}

}  // namespace
}  // namespace throng::app::gait_roles_test
