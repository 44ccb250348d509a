#include "app/window/unsaved_values.h"

#include <gtest/gtest.h>

namespace throng::app::unsaved_values_test {
namespace {

Tuning with_error(float pixels) { return {.error_px = pixels}; }

TEST(UnsavedValues, AreAskedAboutOnce) {
  UnsavedValues unsaved{Tuning()};
  EXPECT_FALSE(unsaved.ask_about(Tuning())) << "nothing was changed";
  EXPECT_TRUE(unsaved.ask_about(with_error(3)));
  EXPECT_FALSE(unsaved.ask_about(with_error(3))) << "the second time they are left";
  EXPECT_TRUE(unsaved.ask_about(with_error(4))) << "but others are not";
}

TEST(UnsavedValues, AreNoneOnceAPresetHasThem) {
  UnsavedValues unsaved{Tuning()};
  unsaved.keep(with_error(3));
  EXPECT_FALSE(unsaved.ask_about(with_error(3)));
  EXPECT_TRUE(unsaved.ask_about(Tuning())) << "the preset has others";
}

TEST(UnsavedValues, AreThoseThatWaitToo) {
  UnsavedValues unsaved{Tuning()};
  TuningPair pair;
  pair.copy_to_other(Tuning());
  EXPECT_FALSE(unsaved.ask_about(Tuning(), pair)) << "a copy";
  pair.copy_to_other(with_error(3));
  EXPECT_TRUE(unsaved.ask_about(Tuning(), pair));
  EXPECT_FALSE(unsaved.ask_about(Tuning(), pair)) << "the second time they are left";
  unsaved.keep_other(with_error(3));
  EXPECT_FALSE(unsaved.ask_about(Tuning(), pair));
  unsaved.keep(with_error(4), pair);
  EXPECT_FALSE(unsaved.ask_about(with_error(4), pair)) << "each is in a preset";
  EXPECT_FALSE(unsaved.ask_about(with_error(3), TuningPair())) << "and stays in it when they change places";
  unsaved.keep(with_error(5));
  EXPECT_TRUE(unsaved.ask_about(with_error(3))) << "nothing waited, so one is kept";
}

TEST(UnsavedValues, AreNotAWayToLook) {
  UnsavedValues unsaved{Tuning()};
  Tuning looked_at;
  looked_at.paused = true;
  looked_at.inspection.thresholds = true;
  looked_at.debug_view = DebugView::error;
  EXPECT_FALSE(unsaved.ask_about(looked_at));
}

}  // namespace
}  // namespace throng::app::unsaved_values_test
