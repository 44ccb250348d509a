#include "app/show/follow_camera.h"

#include <string>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/opened_show.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"
#include "tests/tracks/track_file.h"

namespace throng::app::follow_camera_test {
namespace {

using test::demo;
using test::show_of;
using test::sixtieth;
using testing::HasSubstr;

/// Ann walks to the east, then turns north. Bob comes after four seconds and stays for two.
std::string two_people() {
  std::string text = "id,time,x,y\n";
  for (int row = 0; row <= 100; ++row) {
    const double seconds = 0.1 * row, east = std::min(seconds, 5.0), north = std::max(seconds - 5.0, 0.0);
    text += "ann," + std::to_string(seconds) + "," + std::to_string(east) + "," + std::to_string(north) + "\n";
    if (seconds < 4.0 || seconds > 6.0) continue;
    text += "bob," + std::to_string(seconds) + "," + std::to_string(seconds) + ",-20\n";
  }
  return text;
}

class FollowsInShow : public testing::Test {
 protected:
  std::unique_ptr<Show> show(const std::string& options) const { return show_of(demo(tracks_ + options)); }
  static void pass(Show& show, double seconds) {
    for (double passed = 0.0; passed < seconds; passed += 1.0 / 60.0) show.animate(sixtieth);
  }
  /// Returns where somebody is, seen by the camera: ahead and to the right.
  static glm::vec2 seen(const Show& show, std::size_t agent) {
    const glm::vec3 way = show.stage().crowd().positions()[agent] - show.view().camera.position;
    glm::vec3 ahead = render::forward(show.view().camera);
    ahead = glm::normalize(glm::vec3(ahead.x, 0.0F, ahead.z));
    return {glm::dot(way, ahead), glm::dot(way, render::right(show.view().camera))};
  }
  static std::string refusal(const std::string& options) {
    StartError error;
    EXPECT_EQ(open_show(demo(options), error), nullptr);
    return error.message;
  }

  const TrackFolder folder_;
  const std::string tracks_ = "--trajectories " + folder_.file("two.csv", two_people()) + " ";
};

TEST_F(FollowsInShow, StaysBehindAndTurnsLazily) {
  const auto show = this->show("--camera follow:ann");
  pass(*show, 3.0);
  const glm::vec2 before = seen(*show, 0);
  EXPECT_GT(before.x, 3.0F);
  EXPECT_LT(before.x, 6.0F);
  EXPECT_LT(std::abs(before.y), 0.2F);
  const float yaw = show->view().camera.yaw;
  pass(*show, 2.2);
  EXPECT_LT(show->view().camera.yaw - yaw, 0.6F) << "it turns late";
  pass(*show, 4.5);
  EXPECT_NEAR(show->view().camera.yaw - yaw, 1.5708F, 0.15F);
  EXPECT_LT(std::abs(seen(*show, 0).y), 0.4F);
  EXPECT_NEAR(seen(*show, 0).x, before.x, 0.3F);
}

TEST_F(FollowsInShow, WaitsForTheFirstRowAndStaysAtTheLast) {
  const auto show = this->show("--camera follow:bob");
  const render::Camera before = show->view().camera;
  pass(*show, 3.5);
  EXPECT_LT(glm::distance(show->view().camera.position, before.position), 1e-3F);
  pass(*show, 1.5);
  EXPECT_GT(glm::distance(show->view().camera.position, before.position), 0.5F);
  pass(*show, 2.0);
  const render::Camera after = show->view().camera;
  pass(*show, 2.0);
  EXPECT_LT(glm::distance(show->view().camera.position, after.position), 0.02F);
}

TEST_F(FollowsInShow, GoesOnFromWhereAHandMovedIt) {
  const auto show = this->show("--camera follow:ann");
  pass(*show, 2.0);
  show->view().camera.position.y += 3.0F;
  const float height = show->view().camera.position.y;
  pass(*show, 2.0);
  EXPECT_NEAR(show->view().camera.position.y, height, 0.01F);
  EXPECT_LT(std::abs(seen(*show, 0).y), 0.2F);
}

TEST_F(FollowsInShow, NamesWhomItDoesNotKnow) {
  EXPECT_THAT(refusal(tracks_ + "--camera follow:anna"),
              testing::AllOf(HasSubstr("--camera follow:anna: "), HasSubstr("two.csv has no person of that id"),
                             HasSubstr("nearest are ann, bob")));
  EXPECT_THAT(refusal("--agents 12 --camera follow:#12"), HasSubstr("the crowd has agents #0 to #11"));
}

TEST_F(FollowsInShow, FollowsAnAgentOfAnyCrowdByItsNumber) {
  const auto show = show_of(demo("--agents 12 --camera follow:#0"));
  pass(*show, 5.0);
  EXPECT_NEAR(glm::distance(show->view().camera.position, show->stage().crowd().positions()[0]), 5.0F, 1.2F);
}

TEST_F(FollowsInShow, EndsWithTheSelectionInAWindow) {
  const auto show = show_of(demo("--agents 12"));
  EXPECT_TRUE(show->take(Select{0}));
  show->view().guide.follow_behind(FollowCamera(0), true);
  pass(*show, 1.0);
  EXPECT_TRUE(show->view().guide.follows());
  EXPECT_TRUE(show->take(Select{}));
  const render::Camera before = show->view().camera;
  pass(*show, 1.0);
  EXPECT_FALSE(show->view().guide.follows());
  EXPECT_EQ(show->view().camera, before);
}

}  // namespace
}  // namespace throng::app::follow_camera_test
