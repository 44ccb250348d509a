#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/demo.h"

namespace throng::app::headless_notice_test {
namespace {

using testing::HasSubstr;

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
  EXPECT_THAT(said, HasSubstr(": no multisampling, no shadows unless"));
  EXPECT_EQ(said.find('\n'), said.size() - 1) << said;
}

TEST(HeadlessNotice, LeavesOutWhatWasAskedFor) {
  DemoOptions options = drawn_live_on_the_processor();
  options.values_given.keys.emplace_back("shadows");
  EXPECT_THAT(said_on_stderr(options), HasSubstr("): no multisampling unless"));
  options.msaa = 0;
  EXPECT_EQ(said_on_stderr(options), "");
}

TEST(HeadlessNotice, IsNotNeededForASinglePictureOfFullQuality) {
  DemoOptions options = drawn_live_on_the_processor();
  options.draw = DrawWhich::last;
  EXPECT_EQ(said_on_stderr(options), "");
}

}  // namespace
}  // namespace throng::app::headless_notice_test
