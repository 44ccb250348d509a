// A show of a recorded crowd: its clock, its path, and what is not recorded.
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "app/show/opened_show.h"
#include "app/show/path_in_view.h"
#include "app/show/recording/recorder.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::show_tracks_test {
namespace {

class ShowOfTracks : public test::TemporaryFolder {
 protected:
  ShowOfTracks() {
    std::ofstream file(walk_);
    file << "id,time,x,y\n";
    for (int row = 0; row <= 100; ++row) {
      for (int person = 0; person < 3; ++person) {
        file << person << ',' << 0.1 * row << ',' << 0.12 * row << ',' << person << '\n';
      }
    }
  }
  DemoOptions options(const std::string& more = "") const {
    return test::demo("--trajectories " + walk_.string() + " " + more);
  }
  std::string refusal(const std::string& more) const {
    StartError error;
    return open_show(options(more), error) == nullptr ? error.message : "";
  }
  static const TrackClock& clock(const Show& show) { return show.stage().crowd().tracks()->clock(); }

  const std::filesystem::path walk_ = folder_ / "walk.csv";
};

TEST_F(ShowOfTracks, BeginsAndIsPlayedAsTheOptionsSay) {
  EXPECT_EQ(clock(*test::show_of(options())).seconds, 0.0);
  const auto back = test::show_of(options("--track-rate -2 --track-part 8,3"));
  EXPECT_EQ(clock(*back).seconds, 8.0) << "backwards, so from its end";
  EXPECT_EQ(clock(*back).first, 3.0);
  EXPECT_FALSE(clock(*back).repeats);
  for (int frame = 0; frame < 60; ++frame) back->animate(test::sixtieth);
  EXPECT_NEAR(clock(*back).seconds, 6.0, 1e-6);
  EXPECT_TRUE(clock(*test::show_of(options("--track-repeat"))).repeats);
}

TEST_F(ShowOfTracks, RefusesTimesThatTheFileDoesNotHave) {
  EXPECT_EQ(refusal("--track-part 3,11"),
            "--track-part: " + walk_.string() + " has rows from 0.000000 to 10.000000 s of its clock");
  EXPECT_EQ(refusal("--track-part 3,8 --start 2"), "--start: lies outside of the part that --track-part names");
}

TEST_F(ShowOfTracks, IsNotRecordedAndSaysWhy) {
  const auto show = test::show_of(options());
  const Status started = show->start_recording(folder_ / "run.rec");
  ASSERT_FALSE(started);
  EXPECT_EQ(
      started.error().message,
      "the scene tracks is not recorded: its file shows the same each time, from any --start at any --track-rate");
  EXPECT_FALSE(show->recorder().is_recording());
  test::change(*show, [](Tuning& tuning) { tuning.scene = Scene::grid, tuning.agents = 4; });
  ASSERT_TRUE(show->start_recording(folder_ / "run.rec"));
  Tuning back = show->stage().tuning();
  back.scene = Scene::tracks;
  EXPECT_FALSE(show->take(Apply{back})) << "nor does a recording come to it";
  EXPECT_TRUE(show->stop_recording());
  EXPECT_TRUE(show->take(Apply{back}));
}

TEST_F(ShowOfTracks, KeepsNoMomentsAsAnyIsThere) {
  const auto show = test::show_of(options());
  show->keep_moments();
  for (int frame = 0; frame < 90; ++frame) show->animate(test::sixtieth);
  EXPECT_EQ(show->moments().count(), 0U);
}

TEST_F(ShowOfTracks, KeepsItsClockWithOtherCharacters) {
  const auto show = test::show_of(options());
  TrackClock asked = with_part(clock(*show), 2.0, 6.0);
  asked.rate = 0.5;
  EXPECT_TRUE(show->take(Seek{asked}));
  ASSERT_TRUE(show->take(LoadModels{std::vector<std::string>{THRONG_SOURCE_DIR "/assets/mannequin.glb"}}));
  EXPECT_EQ(clock(*show), asked);
}

TEST_F(ShowOfTracks, HasThePathOfWhoIsSelectedPalerWhereItIsToCome) {
  const auto show = test::show_of(options());
  PathInView path;
  SceneLines lines;
  path.add(lines, show->stage());
  EXPECT_TRUE(lines.empty()) << "nobody is selected";
  EXPECT_TRUE(show->take(Select{1}));
  EXPECT_TRUE(show->take(Seek{gone_to(clock(*show), 5.0)}));
  path.add(lines, show->stage());
  ASSERT_GT(lines.size(), 50U);
  const glm::vec3 now = show->stage().crowd().positions()[1];
  std::size_t walked = 0;
  for (const render::SceneLine& line : lines) {
    const bool is_past = line.color == lines.front().color;
    walked += is_past ? 1 : 0;
    EXPECT_EQ(is_past, line.to.x <= now.x + 1e-3F);
  }
  EXPECT_NEAR(static_cast<double>(walked), static_cast<double>(lines.size()) / 2, 2.0);
  EXPECT_NE(lines.front().color, lines.back().color);
  EXPECT_NEAR(lines.back().to.x - lines.front().from.x, 12.0F, 0.01F);
}

}  // namespace
}  // namespace throng::app::show_tracks_test
