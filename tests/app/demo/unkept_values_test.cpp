#include "app/demo/unkept_values.h"

#include <gtest/gtest.h>

namespace throng::app::unkept_values_test {
namespace {

Tuning with_error(float pixels) { return {.error_px = pixels}; }

TEST(UnkeptValues, AreAskedAboutOnce) {
  UnkeptValues unkept{Tuning()};
  EXPECT_FALSE(unkept.ask_about(Tuning())) << "nothing was changed";
  EXPECT_TRUE(unkept.ask_about(with_error(3)));
  EXPECT_FALSE(unkept.ask_about(with_error(3))) << "the second time they are left";
  EXPECT_TRUE(unkept.ask_about(with_error(4))) << "but others are not";
}

TEST(UnkeptValues, AreNoneOnceAPresetHasThem) {
  UnkeptValues unkept{Tuning()};
  unkept.keep(with_error(3));
  EXPECT_FALSE(unkept.ask_about(with_error(3)));
  EXPECT_TRUE(unkept.ask_about(Tuning())) << "the preset has others";
}

TEST(UnkeptValues, AreNotAWayToLook) {
  UnkeptValues unkept{Tuning()};
  Tuning looked_at;
  looked_at.paused = true;
  looked_at.inspection.thresholds = true;
  looked_at.debug_view = DebugView::error;
  EXPECT_FALSE(unkept.ask_about(looked_at));
}

}  // namespace
}  // namespace throng::app::unkept_values_test
