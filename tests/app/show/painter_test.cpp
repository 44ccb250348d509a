// The painter without a context; tests/gl has what it draws.
#include "app/show/painter.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::painter_test {
namespace {

TEST(PainterWithoutAContext, DrawsNothingAndStillHasPagesForPalettes) {
  auto painter = Painter::create(test::demo("--agents 5"));
  ASSERT_TRUE(painter);
  EXPECT_FALSE((*painter)->draws());
  EXPECT_FALSE((*painter)->is_on_software());
  EXPECT_EQ((*painter)->drawn_by().context, "none");
  EXPECT_EQ((*painter)->notice(), "");
  EXPECT_EQ((*painter)->device_choices().agents, 0);
}

TEST(PainterWithoutAContext, IsDoneWithEveryFrameThatTheStageHasPosed) {
  const auto show = test::show_of(test::demo("--agents 5"));
  for (int frame = 0; frame < 3; ++frame) show->animate(test::sixtieth);
  EXPECT_EQ(show->painter().completed_frame(show->stage()), show->stage().posed().frame());
  EXPECT_EQ(show->stage().posed().frame(), 3U);
  EXPECT_TRUE(show->painter().mesh_levels(0).empty());
}

TEST(PainterWithoutAContext, FreesThePagesOfCharactersThatWereReplaced) {
  const auto show = test::show_of(test::demo("--agents 5"));
  for (int times = 0; times < 3; ++times) {
    ASSERT_TRUE(show->take(LoadModels{std::vector<std::string>{THRONG_SOURCE_DIR "/tests/data/features/plain.glb"}}));
    show->animate(test::sixtieth);
    const auto& pages = dynamic_cast<HeapPageSource&>(show->painter().palette_pages());
    EXPECT_EQ(pages.page_count(), 1U) << times;
  }
}

TEST(PaintedViews, LookForLevelOfDetailFromTheFrozenCamera) {
  PaintedView view{.camera = {.position = {1, 0, 0}}, .frozen = {}, .width = 200, .height = 100};
  EXPECT_EQ(view.lod_camera().position.x, 1.0F);
  view.frozen = render::Camera{.position = {2, 0, 0}};
  EXPECT_EQ(view.lod_camera().position.x, 2.0F);
  EXPECT_EQ(view.aspect(), 2.0F);
}

}  // namespace
}  // namespace throng::app::painter_test
