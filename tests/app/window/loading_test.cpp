// What a person opens is loaded while the crowd goes on.
#include "app/window/loading.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"
#include "tests/tracks/track_file.h"

namespace throng::app::loading_test {
namespace {

using testing::HasSubstr;

const std::string model = THRONG_SOURCE_DIR "/tests/data/features/plain.glb";

class LoadedBeside : public testing::Test {
 protected:
  void begin(const std::string& file) {
    const CrowdRequest request = LoadModels{{file}};
    loading_.begin(show_->plan_for({&request, 1}), [this, request](const auto&) {
      ++taken_;
      EXPECT_TRUE(show_->take(request));
    });
  }
  void go_on_until_it_is_loaded() {
    while (loading_.goes_on()) {
      show_->animate(test::sixtieth);
      loading_.finish();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  const std::string& shown() const { return show_->stage().people().front().file; }

  const std::unique_ptr<Show> show_ = test::show_of(test::demo("--agents 3"));
  Messages messages_;
  Loading loading_{*show_, messages_};
  int taken_ = 0;
};

TEST_F(LoadedBeside, IsShownAtAFrameBoundaryAndNotBefore) {
  begin(model);
  EXPECT_EQ(shown(), "") << "the crowd of before goes on";
  ASSERT_TRUE(loading_.report());
  EXPECT_EQ(loading_.report()->job, SideJob::loading);
  EXPECT_THAT(loading_.report()->words, HasSubstr("plain.glb"));
  go_on_until_it_is_loaded();
  EXPECT_EQ(shown(), model);
  EXPECT_FALSE(loading_.report());
}

TEST_F(LoadedBeside, ChangesNothingOnceItIsCancelled) {
  begin(model);
  loading_.cancel();
  EXPECT_FALSE(loading_.goes_on());
  EXPECT_THAT(messages_.all().back().words, HasSubstr("plain.glb is not loaded"));
  for (int frame = 0; frame < 100; ++frame) {
    loading_.finish();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(shown(), "");
  EXPECT_EQ(taken_, 0);
}

TEST_F(LoadedBeside, GivesWayToWhatIsOpenedAfterIt) {
  begin(THRONG_SOURCE_DIR "/tests/data/features/weights-u8.glb");
  begin(model);
  ASSERT_FALSE(messages_.all().empty());
  EXPECT_THAT(messages_.all().back().words, HasSubstr("weights-u8.glb is not loaded"));
  go_on_until_it_is_loaded();
  EXPECT_EQ(shown(), model);
  EXPECT_EQ(taken_, 1);
}

TEST_F(LoadedBeside, IsTakenWithoutAnotherLookAtTheFile) {
  const TrackFolder folder;
  const std::string copy = folder.path("copy.glb");
  std::filesystem::copy_file(model, copy);
  const CrowdRequest request = LoadModels{{copy}};
  loading_.begin(show_->plan_for({&request, 1}), [&](const auto&) {
    std::filesystem::remove(copy);
    EXPECT_TRUE(show_->take(request));
  });
  go_on_until_it_is_loaded();
  EXPECT_EQ(shown(), copy);
}

TEST_F(LoadedBeside, SaysWhyItCannotBeShown) {
  const CrowdRequest request = LoadModels{{"nothing.glb"}};
  loading_.begin(
      show_->plan_for({&request, 1}), [this](const auto&) { ++taken_; }, "mine.throng");
  go_on_until_it_is_loaded();
  EXPECT_THAT(messages_.all().back().words, HasSubstr("mine.throng: "));
  EXPECT_THAT(messages_.all().back().words, HasSubstr("nothing.glb"));
  EXPECT_EQ(messages_.all().back().kind, Message::Kind::refused);
  EXPECT_EQ(taken_, 0);
}

TEST_F(LoadedBeside, IsMadeAtOnceWhereNothingIsToBeLoaded) {
  loading_.begin({}, [this](const auto&) { ++taken_; });
  EXPECT_EQ(taken_, 1);
}

}  // namespace
}  // namespace throng::app::loading_test
