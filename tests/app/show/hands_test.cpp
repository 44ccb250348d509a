#include "app/show/hands.h"

#include <gtest/gtest.h>

#include "tests/app/recording/recorded_run.h"

namespace throng::app::hands_test {
namespace {

using test::demo;
using test::show_of;
using test::sixtieth;

class HandsOfAShow : public testing::Test {
 protected:
  void SetUp() override { show_->animate(sixtieth); }

  const std::unique_ptr<Show> show_ = show_of(demo("--agents 12"));
};

TEST_F(HandsOfAShow, SelectTheAgentThatIsSeenAtAPixel) {
  const auto bodies = bodies_in_view(show_->stage());
  ASSERT_FALSE(bodies.empty());
  const UprightBody& body = bodies.back();
  show_->camera = {.position = body.foot + glm::vec3(0, 0.5F * body.height, 1.0F)};
  show_->hands().select_at(0.5F * static_cast<float>(show_->width), 0.5F * static_cast<float>(show_->height));
  EXPECT_EQ(show_->stage().selected(), body.agent);
}

TEST_F(HandsOfAShow, DeselectInTheSky) {
  show_->hands().select(3);
  ASSERT_EQ(show_->stage().selected(), 3U);
  show_->camera.pitch = 1.5F;
  show_->hands().select_at(1, 1);
  EXPECT_FALSE(show_->stage().selected());
}

TEST_F(HandsOfAShow, PushTheSelectedAgentAndNobodyElse) {
  EXPECT_TRUE(show_->hands().push_selected()) << "nobody is selected";
  EXPECT_TRUE(show_->stage().animated().fallen().fallen().empty());
  show_->hands().select(3);
  EXPECT_TRUE(show_->hands().push_selected());
  ASSERT_EQ(show_->stage().animated().fallen().fallen().size(), 1U);
  EXPECT_EQ(show_->stage().animated().fallen().fallen()[0].agent, 3U);
}

TEST_F(HandsOfAShow, HoldTheClipOfTheSelectedAgentUntilTheyLetGo) {
  show_->hands().hold_selected_clip(0.25F);
  EXPECT_FALSE(show_->stage().animated().held_clip()) << "nobody is selected";
  show_->hands().select(5);
  show_->hands().hold_selected_clip(0.25F);
  ASSERT_TRUE(show_->stage().animated().held_clip());
  EXPECT_EQ(show_->stage().animated().held_clip()->agent, 5U);
  show_->hands().let_go_of_clip();
  EXPECT_FALSE(show_->stage().animated().held_clip());
}

}  // namespace
}  // namespace throng::app::hands_test
