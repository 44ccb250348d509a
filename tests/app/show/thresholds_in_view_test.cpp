#include "app/show/thresholds_in_view.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::thresholds_in_view_test {
namespace {

TEST(ThresholdsOfAClip, AreOfACharacterThatIsThereWhereModelsWereReplacedAndNobodyIsInView) {
  const auto show = test::show_of(test::demo("--agents 300 --error-px 1"));
  ThresholdsInView thresholds;
  for (int frame = 0; frame < 3; ++frame) show->animate(test::sixtieth);
  thresholds.update(show->stage(), show->view().camera, 720);
  ASSERT_NE(thresholds.clip(), "");
  ASSERT_NE(thresholds.clip(), "standing still");

  ASSERT_TRUE(
      show->take(LoadModels{std::vector<std::string>{THRONG_SOURCE_DIR "/tests/data/features/no-animation.glb"}}));
  show->view().films = false;
  show->view().camera = {.position = {0, 500, 0}, .pitch = 1.5F};
  show->animate(test::sixtieth);
  ASSERT_TRUE(show->stage().posed().selection().visible.empty());
  thresholds.update(show->stage(), show->view().camera, 720);
  EXPECT_EQ(thresholds.clip(), "standing still");
  EXPECT_EQ(thresholds.character(), 0U);
}

}  // namespace
}  // namespace throng::app::thresholds_in_view_test
