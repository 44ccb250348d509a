#include "app/settings/user_settings.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/settings/quality.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::user_settings_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class UserSettingsFile : public test::TemporaryFolder {
 protected:
  std::filesystem::path written(const std::string& text) const {
    std::ofstream(file_) << text;
    return file_;
  }
  std::string complaint(const std::string& text) const {
    const auto read = read_user_settings(written(text));
    return read ? "(none)" : read.error().message;
  }

  std::filesystem::path file_ = folder_ / "settings.json";
};

TEST_F(UserSettingsFile, GivesBackWhatWasWrittenAndMakesItsFolder) {
  const UserSettings settings{.quality = "medium",
                              .width = 800,
                              .height = 600,
                              .panel_width = 420,
                              .recent_files = {"/crowds/a.throng"},
                              .output = {.picture_times = 3, .video_seconds = 2.5}};
  const std::filesystem::path file = folder_ / "throng" / "settings.json";
  ASSERT_TRUE(write_user_settings(file, settings));
  EXPECT_EQ(read_user_settings(file).value(), settings);
}

TEST_F(UserSettingsFile, IsNotNeeded) { EXPECT_EQ(read_user_settings(file_).value(), UserSettings()); }

TEST_F(UserSettingsFile, ThatIsDamagedIsNamedWithTheRemedy) {
  const auto names_all = [&](const char* what) {
    return AllOf(HasSubstr("settings.json: "), HasSubstr(what), HasSubstr("; delete the file"));
  };
  EXPECT_THAT(complaint("{"), names_all(""));
  EXPECT_THAT(complaint(R"({"version": 1, "quality": "best"})"), names_all("\"quality\" must be low"));
  EXPECT_THAT(complaint(R"({"version": 1, "size": "0x600"})"), names_all("\"size\" must be WIDTHxHEIGHT"));
  EXPECT_THAT(complaint(R"({"version": 1, "panel_width": -3})"), names_all("\"panel_width\" must be"));
  EXPECT_THAT(complaint(R"({"version": 1, "recent_files": "a"})"), names_all("\"recent_files\" must be an array"));
  EXPECT_THAT(complaint(R"({"version": 1, "picture_times": 5})"),
              names_all("\"picture_times\" must be a whole number"));
}

TEST(TakenUserSettings, StartAWindowWhereTheCommandLineSaysNothing) {
  DemoOptions options;
  take_user_settings({.quality = "low", .width = 800, .height = 600, .recent_files = {}}, options);
  EXPECT_EQ(options.width, 800);
  EXPECT_EQ(options.height, 600);
  EXPECT_EQ(quality_of(options.tuning), "low");
}

TEST(TakenUserSettings, LeaveWhatTheCommandLineSays) {
  DemoOptions options;
  options.given = {"--size"};
  options.values_given.keys = {"shadows"};
  take_user_settings({.quality = "low", .width = 800, .height = 600, .recent_files = {}}, options);
  EXPECT_EQ(options.width, 1280);
  EXPECT_EQ(quality_of(options.tuning), "high");
}

}  // namespace
}  // namespace throng::app::user_settings_test
