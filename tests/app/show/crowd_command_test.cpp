// The command line that a window copies, as a person reads it. tests/gl/described_crowd_test.cpp runs it again.
#include "app/show/request/crowd_command.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::crowd_command_test {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class CopiedCommand : public test::TemporaryFolder {
 protected:
  std::string model(const std::string& name) const {
    fs::copy_file(THRONG_SOURCE_DIR "/tests/data/features/plain.glb", folder_ / name);
    return (folder_ / name).string();
  }
  static std::unique_ptr<Show> show_of_models(const std::vector<std::string>& models) {
    auto options = test::demo("--agents 3");
    options.models = models;
    return test::show_of(options);
  }
  static std::string command(const Show& show) {
    return crowd_command(crowd_setup(show.stage().people(), {.tuning = {}, .camera = {}}), show.stage().people());
  }
};

TEST_F(CopiedCommand, BeginsWithTheProgramAndQuotesForAShell) {
  const auto show = show_of_models({model("a person's $1.glb")});
  EXPECT_THAT(command(*show), StartsWith("throng '" + folder_.string() + "/a person'\\''s $1.glb' --agents 1000"));
}

TEST_F(CopiedCommand, NamesTheRolesOfOneCharacter) {
  const auto show = test::show_of(test::demo("--agents 3"));
  RoleClips clips = show->stage().people()[0].roles.clips;
  clips[index_of(Role::wave)] = no_clip;
  test::ask(*show, SetRoles{0, clips});
  EXPECT_THAT(command(*show), StartsWith("throng --clips wave=none --agents 1000 "));
  EXPECT_THAT(command(*show), Not(HasSubstr("--crowd ")));
}

TEST_F(CopiedCommand, NamesShares) {
  const std::string one = model("one.glb"), two = model("two.glb");
  const auto show = show_of_models({one, two});
  EXPECT_THAT(command(*show), StartsWith("throng " + one + " " + two + " --agents"));
  test::ask(*show, SetShare{1, 2.5});
  EXPECT_THAT(command(*show), StartsWith("throng --cast '" + one + "*1," + two + "*2.5' --agents"));
}

TEST_F(CopiedCommand, SaysAsTextWhatNoOptionSays) {
  const auto show = test::show_of(test::demo("--agents 3"));
  CrowdSetup setup = crowd_setup(show->stage().people(), {.tuning = {}, .camera = {}});
  setup.bookmarks[2] = CameraPose{.x = 1};
  EXPECT_THAT(crowd_command(setup, show->stage().people()),
              EndsWith(R"( --crowd '{"bookmarks":{"3":"1,0,0,0,0,50"}}')"));
}

TEST_F(CopiedCommand, NamesARecordedCrowdByItsOptions) {
  const auto show = test::show_of(test::demo("--agents 3"));
  CrowdSetup setup = crowd_setup(show->stage().people(), {.tuning = {.scene = Scene::tracks}, .camera = {}});
  setup.trajectories = {.file = "-walk.csv", .reading = {.up = TrackUp::y, .walls = "my hall.wkt"}, .repeats = true};
  EXPECT_THAT(crowd_command(setup, show->stage().people()),
              StartsWith("throng --trajectories ./-walk.csv --walls 'my hall.wkt' --track-repeat=on --up -walk=y "
                         "--shadows on"));
}

}  // namespace
}  // namespace throng::app::crowd_command_test
