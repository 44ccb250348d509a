#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/demo.h"

namespace throng::app::headless_notice_test {
namespace {

using testing::HasSubstr;
using testing::Not;

DemoOptions drawn_live_on_the_processor() {
  DemoOptions options;
  options.context = ContextKind::egl;
  options.force_software = true;
  options.tuning.agents = 3;
  options.values_given.keys.emplace_back("agents");
  options.draw = DrawWhich::all;
  options.frames = 2;
  options.width = 320;
  options.height = 180;
  return options;
}

std::string said_on_stderr(const DemoOptions& options) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_demo(options), 0);
  return testing::internal::GetCapturedStderr();
}

TEST(HeadlessNotice, NamesInOneLineWhatASoftwareRendererTurnsDown) {
  const std::string said = said_on_stderr(drawn_live_on_the_processor());
  EXPECT_THAT(said, HasSubstr("it starts with no multisampling and no shadows; --msaa and --shadows change that.\n"));
  EXPECT_EQ(std::ranges::count(said, '\n'), 2) << "the notice, and what the run did: " << said;
}

TEST(HeadlessNotice, LeavesOutWhatWasAskedFor) {
  DemoOptions options = drawn_live_on_the_processor();
  options.values_given.keys.emplace_back("shadows");
  EXPECT_THAT(said_on_stderr(options), HasSubstr("it starts with no multisampling; --msaa changes that.\n"));
  options.msaa = 0;
  EXPECT_THAT(said_on_stderr(options), Not(HasSubstr("No graphics card")));
}

TEST(HeadlessNotice, IsNotNeededForASinglePictureOfFullQuality) {
  DemoOptions options = drawn_live_on_the_processor();
  options.draw = DrawWhich::last;
  EXPECT_THAT(said_on_stderr(options), Not(HasSubstr("No graphics card")));
}

}  // namespace
}  // namespace throng::app::headless_notice_test
