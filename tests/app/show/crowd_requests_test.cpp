// Requests about the crowd: what they do, and that a request which cannot be is refused in words and changes nothing.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/request/request_json.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::crowd_requests_test {
namespace {

using test::demo;
using test::show_of;
using test::sixtieth;
using testing::HasSubstr;

class CrowdRequests : public testing::Test {
 protected:
  void SetUp() override { show_->animate(sixtieth); }
  std::string refusal_of(const CrowdRequest& request) const {
    const Status taken = show_->take(request);
    return taken ? "(taken)" : taken.error().message;
  }

  const std::unique_ptr<Show> show_ = show_of(demo("--agents 12"));
};

TEST_F(CrowdRequests, SelectTheAgentThatIsSeenAtAPixel) {
  const auto bodies = bodies_in_view(show_->stage());
  ASSERT_FALSE(bodies.empty());
  const UprightBody& body = bodies.back();
  show_->view().camera = {.position = body.foot + glm::vec3(0, 0.5F * body.height, 1.0F)};
  const auto middle = glm::vec2(glm::ivec2(show_->view().width, show_->view().height)) * 0.5F;
  EXPECT_TRUE(show_->take(Select{show_->agent_at(middle.x, middle.y)}));
  EXPECT_EQ(show_->stage().selected(), body.agent);
}

TEST_F(CrowdRequests, DeselectWhereAClickMeetsTheSky) {
  EXPECT_TRUE(show_->take(Select{3}));
  ASSERT_EQ(show_->stage().selected(), 3U);
  show_->view().camera.pitch = 1.5F;
  EXPECT_TRUE(show_->take(Select{show_->agent_at(1, 1)}));
  EXPECT_FALSE(show_->stage().selected());
}

TEST_F(CrowdRequests, PushOneAgent) {
  EXPECT_TRUE(show_->take(Push{3, {0, 0, -1}}));
  ASSERT_EQ(show_->stage().animated().fallen().fallen().size(), 1U);
  EXPECT_EQ(show_->stage().animated().fallen().fallen()[0].agent, 3U);
}

TEST_F(CrowdRequests, HoldAClipUntilItIsLetGo) {
  EXPECT_TRUE(show_->take(Hold{5, 0.25F}));
  ASSERT_TRUE(show_->stage().animated().held_clip());
  EXPECT_EQ(show_->stage().animated().held_clip()->agent, 5U);
  EXPECT_TRUE(show_->take(Hold{}));
  EXPECT_FALSE(show_->stage().animated().held_clip());
}

TEST_F(CrowdRequests, ThatCannotBeAreRefusedInWordsAndChangeNothing) {
  const std::vector<ChosenCharacter> before = exactly(show_->stage().people());
  EXPECT_EQ(refusal_of(Select{12}), "there is no agent 12, only 0 to 11");
  EXPECT_EQ(refusal_of(Push{99, {}}), "there is no agent 99, only 0 to 11");
  EXPECT_EQ(refusal_of(Hold{12, 1.0F}), "there is no agent 12, only 0 to 11");
  for (const CrowdRequest& request : std::vector<CrowdRequest>{SetShare{3, 2.0}, SetRoles{3, {}}, SetBody{3, {}},
                                                               SetBones{3, {}}, SetPlacement{3, {}}, SetRules{3, ""}}) {
    EXPECT_EQ(refusal_of(request), "there is no character 3, only 0 to 0") << to_json(request).dump();
  }
  EXPECT_EQ(refusal_of(SetShare{0, 0.0}), "a share must be above 0 and at most 10000");
  RoleClips clips = no_clips();
  clips.front() = 10'000;
  EXPECT_EQ(refusal_of(SetRoles{0, clips}), "mannequin (built in) has no such clip");
  EXPECT_EQ(refusal_of(SetCast{}), "a crowd has 1 to 30 characters, not 0");
  EXPECT_THAT(refusal_of(LoadModels{{"none.glb"}}), HasSubstr("none.glb"));
  EXPECT_THAT(refusal_of(GoBack{}), HasSubstr("there is no earlier moment"));
  EXPECT_THAT(refusal_of(Seek{}), HasSubstr("follows no file"));
  EXPECT_EQ(exactly(show_->stage().people()), before);
}

}  // namespace
}  // namespace throng::app::crowd_requests_test
