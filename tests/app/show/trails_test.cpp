// The lines on the ground where people of a file went.

#include "app/show/trails.h"

#include <cmath>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/settings/agent_colors.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::app::trails_test {
namespace {

/// One who walks straight on along x at 1 m/s from 0 to 20 s, and one who walks round in a circle of 2 m from 5 s on.
std::shared_ptr<const Trajectories> two_people() {
  Trajectories all;
  for (int person = 0; person < 2; ++person) {
    PersonTrack track{.id = std::to_string(person), .rows = {}};
    for (int row = 125 * person; row <= 500; ++row) {
      const double seconds = 0.04 * row, angle = 0.5 * seconds;
      const glm::dvec2 at =
          person == 0 ? glm::dvec2(seconds, 0.0) : glm::dvec2(8.0 + 2.0 * std::cos(angle), 2.0 * std::sin(angle));
      track.rows.push_back({.seconds = seconds, .x = static_cast<float>(at.x), .z = static_cast<float>(at.y)});
    }
    all.row_count += track.rows.size();
    all.persons.push_back(std::move(track));
  }
  all.rows_a_second = 25.0;
  all.last_seconds = 20.0;
  return std::make_shared<const Trajectories>(std::move(all));
}

class TrailsOfTwo : public testing::Test {
 protected:
  TrailsOfTwo() {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin"));
    tuning_.scene = Scene::tracks;
    tuning_.trail_seconds = 4.0F;
    auto made = Stage::create(std::move(characters), tuning_, pages_, 0, two_people());
    EXPECT_TRUE(made) << made.error().message;
    stage_ = std::move(*made);
  }

  SceneLines lines_at(double seconds) { return lines_at(seconds, trails_); }
  SceneLines lines_at(double seconds, Trails& trails) {
    EXPECT_TRUE(stage_->apply(tuning_));
    TrackClock clock = stage_->crowd().tracks()->clock();
    clock.seconds = seconds;
    stage_->set_track_clock(clock);
    stage_->move({});
    stage_->pose(camera_, 1280, 720, {}, stage_->posed().frame());
    SceneLines lines;
    trails.add(lines, *stage_, camera_, {1280, 720});
    return lines;
  }
  glm::vec3 place(std::size_t agent, double seconds) const {
    return stage_->crowd().tracks()->people().position(agent, seconds);
  }
  static float length_of(const SceneLines& lines) {
    float length = 0.0F;
    for (const render::SceneLine& line : lines) length += glm::distance(line.from, line.to);
    return length;
  }

  Tuning tuning_;
  HeapPageSource pages_{std::size_t{4} << 20U};
  std::unique_ptr<Stage> stage_;
  Trails trails_;
  render::Camera camera_ = camera_at({.x = 8, .y = 20, .z = 10, .yaw = 0, .pitch = -60});
};

constexpr float height = 0.05F;  // metres, above the ground

TEST_F(TrailsOfTwo, GoBackAlongTheWayOfTheLastSeconds) {
  const SceneLines lines = lines_at(4.5);
  ASSERT_FALSE(lines.empty());
  EXPECT_LT(glm::distance(lines.front().from, place(0, 4.5)), height);
  EXPECT_LT(glm::distance(lines.back().to, place(0, 0.5)), height);
  EXPECT_NEAR(length_of(lines), 4.0F, 0.01F);
}

TEST_F(TrailsOfTwo, BeginWhereSomebodyAppeared) {
  EXPECT_NEAR(length_of(lines_at(1.5)), 1.5F, 0.01F);
  const SceneLines lines = lines_at(6.0);
  EXPECT_LT(glm::distance(lines.back().to, place(1, 5.0)), height);
}

TEST_F(TrailsOfTwo, FollowACurveAsCloselyAsOneSees) {
  const SceneLines lines = lines_at(16.0);
  EXPECT_NEAR(length_of(lines), 4.0F + 4.0F, 0.05F) << "a metre a second each";
}

TEST_F(TrailsOfTwo, AreTheSameWhereverTheClockCameFrom) {
  for (const double before : {3.0, 12.0, 12.7, 19.0}) {
    Trails fresh;
    static_cast<void>(lines_at(before));
    const SceneLines kept = lines_at(13.0), made_anew = lines_at(13.0, fresh);
    ASSERT_EQ(kept.size(), made_anew.size()) << before;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      EXPECT_EQ(kept[i].from, made_anew[i].from) << before;
      EXPECT_EQ(kept[i].color, made_anew[i].color) << before;
    }
  }
}

TEST_F(TrailsOfTwo, FadeTowardsThePast) {
  const SceneLines lines = lines_at(4.5);
  for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_LT(lines[i].color >> 24U, lines[i - 1].color >> 24U);
}

TEST_F(TrailsOfTwo, HaveTheColourOfTheView) {
  const auto color = [this] { return lines_at(4.5).front().color & 0xFFFFFFU; };
  const std::uint32_t plain = color();
  tuning_.debug_view = DebugView::speed;
  EXPECT_NE(color(), plain);
  EXPECT_EQ(color(), scale_color(stage_->posed().measures().of(0) / tuning_.top_speed) & 0xFFFFFFU);
}

TEST_F(TrailsOfTwo, OfAStraightWayAreFewLines) {
  EXPECT_LE(lines_at(4.5).size(), 10U);
  EXPECT_GT(lines_at(16.0).size(), 10U) << "with the circle";
}

TEST_F(TrailsOfTwo, AreNotDrawnOutOfViewNorWhereNobodyAsks) {
  camera_ = camera_at({.x = 8, .y = 2, .z = 10, .yaw = 180, .pitch = 0});
  EXPECT_TRUE(lines_at(16.0).empty());
  camera_ = camera_at({.x = 8, .y = 20, .z = 10, .yaw = 0, .pitch = -60});
  tuning_.trail_seconds = 0.0F;
  EXPECT_TRUE(lines_at(16.0).empty());
}

TEST_F(TrailsOfTwo, AllocateNothingOnceTheyAreThere) {
  SceneLines lines = lines_at(16.0);
  lines.clear();
  const HotPathCounts before = hot_path_counts();
  trails_.add(lines, *stage_, camera_, {1280, 720});
  EXPECT_EQ((hot_path_counts() - before).allocations, 0U);
}

}  // namespace
}  // namespace throng::app::trails_test
