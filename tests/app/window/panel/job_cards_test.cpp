// A card tells how far a job is that goes on beside the crowd.
#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::job_cards_test {
namespace {

struct JobCards : testing::Test {
  JobCards() {
    driver.report.jobs = {{.job = SideJob::loading, .words = "Knight.glb: clip 26 of 76", .share = 0.3},
                          {.job = SideJob::video, .words = "throng-1.mp4: frame 9 of 60", .share = 0.15}};
    driver.frames();
  }
  OverlayDriver driver;
};

TEST_F(JobCards, AreThereAsLongAsTheirJobs) {
  EXPECT_TRUE(driver.sees("job:loading"));
  EXPECT_TRUE(driver.sees("job:video"));
  driver.report.jobs.clear();
  driver.frames();
  EXPECT_FALSE(driver.sees("job:loading"));
}

TEST_F(JobCards, CancelTheirJob) {
  EXPECT_EQ(asked<CancelJob>(driver.click("cancel:loading")).job, SideJob::loading);
  EXPECT_EQ(asked<CancelJob>(driver.click("cancel:video")).job, SideJob::video);
}

TEST_F(JobCards, LieOverNoOtherNotice) {
  driver.report.messages.say("Wrote throng-1.png");
  driver.frames();
  const UiRectangle* const card = driver.find("job:video");
  const UiRectangle* const message = driver.find("message:0");
  ASSERT_TRUE(card != nullptr && message != nullptr);
  EXPECT_GE(message->y, card->y + card->height);
}

TEST(StartCard, TellsHowFarTheStartIsAndGivesItUp) {
  OverlayDriver driver;
  const auto frame = [&driver] {
    driver.overlay.begin_frame(OverlayDriver::width, OverlayDriver::height, 0.04, driver.input.next_frame());
    return driver.overlay.build_start({.job = SideJob::loading, .words = "reading characters", .share = 0.2});
  };
  EXPECT_FALSE(frame());
  EXPECT_TRUE(driver.sees("job:loading"));
  EXPECT_FALSE(driver.sees("tab:Crowd")) << "there is no crowd yet";
  driver.hold(Key::escape);
  EXPECT_TRUE(frame());
}

}  // namespace
}  // namespace throng::app::job_cards_test
