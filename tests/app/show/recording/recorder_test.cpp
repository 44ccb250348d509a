#include "app/show/recording/recorder.h"

#include <csignal>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::recorder_test {
namespace {

class Recorders : public test::RecordedRun {
 protected:
  Recorder recorder_;
};

TEST_F(Recorders, IgnoreWhatTheyAreToldWhileNoFileIsOpen) {
  recorder_.add(CrowdRequest(GoBack{}));
  EXPECT_FALSE(recorder_.is_recording());
  EXPECT_TRUE(recorder_.stop());
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(Recorders, PutTheFileInItsPlaceWhenTheyStop) {
  ASSERT_TRUE(recorder_.start(file_, {.characters = {}, .tuning = {}, .width = 8, .height = 8}));
  EXPECT_TRUE(recorder_.is_recording());
  recorder_.add(CrowdRequest(GoBack{}));
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_TRUE(recorder_.stop());
  EXPECT_TRUE(std::filesystem::exists(file_));
  EXPECT_FALSE(recorder_.is_recording());
}

TEST_F(Recorders, RecordNothingWhereTheFileCannotBeWritten) {
  EXPECT_FALSE(
      recorder_.start(folder_ / "no" / "folder.rec", {.characters = {}, .tuning = {}, .width = 8, .height = 8}));
  EXPECT_FALSE(recorder_.is_recording());
}

TEST_F(Recorders, SayAFullDiskWhenItHappensAndKeepTheFramesBefore) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 100'000;
  ASSERT_TRUE(recorder_.start(file_, {.characters = {}, .tuning = {}, .width = 8, .height = 8}));
  setrlimit(RLIMIT_FSIZE, &small);
  int requests = 0;
  for (; recorder_.is_recording() && requests < 100'000; ++requests) recorder_.add(CrowdRequest(Select{}));
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_LT(requests, 100'000) << "it goes on";
  ASSERT_FALSE(recorder_.outcome());
  EXPECT_THAT(recorder_.outcome().error().message, testing::HasSubstr("cannot be written: File too large"));
  EXPECT_THAT(recorder_.stop().error().message, testing::HasSubstr("; the frames before are in "));
  EXPECT_TRUE(recorder_.stop()) << "it is said once";
  EXPECT_FALSE(std::filesystem::exists(file_));
}

}  // namespace
}  // namespace throng::app::recorder_test
