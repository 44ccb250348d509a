#include "app/window/unsaved_work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::unsaved_work_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Tuning with_error(float pixels) { return {.error_px = pixels}; }

/// Compares values alone.
std::vector<std::string> parts(const UnsavedWork& unsaved, const Tuning& tuning, const TuningPair& pair = {}) {
  return unsaved.parts(tuning, pair, {});
}

TEST(UnsavedWork, HasTheValuesThatNoPresetHas) {
  UnsavedWork unsaved{Tuning()};
  EXPECT_THAT(parts(unsaved, Tuning()), IsEmpty()) << "nothing was changed";
  EXPECT_THAT(parts(unsaved, with_error(3)), ElementsAre("the values"));
  unsaved.keep(with_error(3));
  EXPECT_THAT(parts(unsaved, with_error(3)), IsEmpty());
  EXPECT_THAT(parts(unsaved, Tuning()), ElementsAre("the values")) << "the preset has others";
}

TEST(UnsavedWork, HasTheValuesThatWaitToo) {
  UnsavedWork unsaved{Tuning()};
  TuningPair pair;
  pair.copy_to_other(Tuning());
  EXPECT_THAT(parts(unsaved, Tuning(), pair), IsEmpty()) << "a copy";
  pair.copy_to_other(with_error(3));
  EXPECT_THAT(parts(unsaved, Tuning(), pair), ElementsAre("the values"));
  unsaved.keep_other(with_error(3));
  EXPECT_THAT(parts(unsaved, Tuning(), pair), IsEmpty());
  unsaved.keep(with_error(4), pair);
  EXPECT_THAT(parts(unsaved, with_error(4), pair), IsEmpty()) << "each is in a preset";
  EXPECT_THAT(parts(unsaved, with_error(3)), IsEmpty()) << "and stays in it when they change places";
  unsaved.keep(with_error(5));
  EXPECT_THAT(parts(unsaved, with_error(3)), ElementsAre("the values")) << "nothing waited, so one is kept";
}

TEST(UnsavedWork, IsNoWayToLookAndNoPaceOfTheWindow) {
  const UnsavedWork unsaved{Tuning()};
  Tuning looked_at;
  looked_at.paused = true;
  looked_at.inspection.thresholds = true;
  looked_at.debug_view = DebugView::error;
  looked_at.frame_limit = 30;
  looked_at.vertical_sync = false;
  EXPECT_THAT(parts(unsaved, looked_at), IsEmpty());
}

TEST(UnsavedWork, HasChoicesForCharactersAndPlacesOfTheCamera) {
  UnsavedWork unsaved{Tuning()};
  CrowdWork work{.characters = {{.file = "fox.glb"}}};
  unsaved.keep(work);
  work.characters.front().share = 2;
  work.places.front() = CameraPose{.x = 1};
  EXPECT_THAT(unsaved.parts({}, {}, work), ElementsAre("the choices for the characters", "the places of the camera"));
  unsaved.keep(work.characters);
  EXPECT_THAT(unsaved.parts({}, {}, work), ElementsAre("the places of the camera")) << "the characters were opened";
  unsaved.keep(work);
  EXPECT_THAT(unsaved.parts({}, {}, work), IsEmpty());
}

struct RecordedCrowd : testing::Test {
  RecordedCrowd() { unsaved.keep(work); }

  RecordedView& view() { return *work.recorded; }

  UnsavedWork unsaved{Tuning()};
  CrowdWork work{.recorded = RecordedView{.clock = {.seconds = 1, .first = 0, .last = 9}, .camera = CameraPose()}};
};

TEST_F(RecordedCrowd, HasATimeWhereAPersonHoldsIt) {
  view().clock.seconds = 5;
  EXPECT_THAT(unsaved.parts({}, {}, work), IsEmpty()) << "it plays";
  EXPECT_THAT(unsaved.parts({.paused = true}, {}, work), ElementsAre("the time of the recorded crowd"));
}

TEST_F(RecordedCrowd, HasAPartAndARate) {
  view().clock.first = 2;
  EXPECT_THAT(unsaved.parts({}, {}, work), ElementsAre("the time of the recorded crowd"));
  view().clock.first = 0;
  view().clock.rate = 4;
  EXPECT_THAT(unsaved.parts({}, {}, work), ElementsAre("the time of the recorded crowd"));
}

TEST_F(RecordedCrowd, HasACameraThatDoesNotMoveByItself) {
  view().camera->x = 3;
  EXPECT_THAT(unsaved.parts({}, {}, work), ElementsAre("its camera"));
  view().camera.reset();
  EXPECT_THAT(unsaved.parts({}, {}, work), IsEmpty());
}

}  // namespace
}  // namespace throng::app::unsaved_work_test
