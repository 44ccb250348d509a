#include "app/recording/recorder.h"

#include "tests/app/recording/recorded_run.h"

namespace throng::app::recorder_test {
namespace {

class Recorders : public test::RecordedRun {
 protected:
  Recorder recorder_;
};

TEST_F(Recorders, IgnoreWhatTheyAreToldWhileNoFileIsOpen) {
  recorder_.add(RecordedRewind{});
  EXPECT_FALSE(recorder_.is_recording());
  EXPECT_TRUE(recorder_.stop());
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(Recorders, PutTheFileInItsPlaceWhenTheyStop) {
  ASSERT_TRUE(recorder_.start(file_, {.characters = {}, .tuning = {}, .width = 8, .height = 8}));
  EXPECT_TRUE(recorder_.is_recording());
  recorder_.add(RecordedRewind{});
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

}  // namespace
}  // namespace throng::app::recorder_test
