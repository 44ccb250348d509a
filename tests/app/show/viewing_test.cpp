// The crowd waits while one of its characters is viewed alone.

#include <string>

#include <gtest/gtest.h>

#include "app/show/opened_show.h"
#include "app/show/stage/stage.h"
#include "app/show/viewer/viewer.h"
#include "app/window/viewer_requests.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::viewing_test {
namespace {

using test::demo;
using test::show_of;
using test::sixtieth;

void animate(Show& show, int frames) {
  for (int i = 0; i < frames; ++i) show.animate(sixtieth);
}

std::uint64_t hash_of(const Show& show) { return show.stage().system().figures().pose_hash(); }

TEST(ViewedCharacterOfACrowd, LeavesTheCrowdAsItWas) {
  const auto seen = show_of(demo("--agents 40")), never = show_of(demo("--agents 40"));
  animate(*seen, 20);
  animate(*never, 20);
  EXPECT_TRUE(seen->take(Select{7}));
  EXPECT_TRUE(never->take(Select{7}));
  ASSERT_TRUE(take(ViewSelected{}, *seen));
  ASSERT_NE(seen->viewer(), nullptr);
  animate(*seen, 100);
  EXPECT_EQ(hash_of(*seen), hash_of(*never)) << "the crowd waits";
  ASSERT_TRUE(take(LeaveViewer{}, *seen));
  EXPECT_EQ(seen->viewer(), nullptr);
  EXPECT_EQ(seen->stage().selected(), 7U);
  animate(*seen, 20);
  animate(*never, 20);
  EXPECT_EQ(hash_of(*seen), hash_of(*never)) << "and goes on where it was";
}

TEST(ViewedCharacterOfACrowd, IsShownInTheClipOfTheSelectedAgent) {
  const auto show = show_of(demo("--agents 40"));
  animate(*show, 5);
  EXPECT_TRUE(show->take(Select{3}));
  ASSERT_TRUE(take(ViewSelected{}, *show));
  EXPECT_EQ(show->viewer()->settings().clip, show->stage().crowd().minds().clips()[3]);
}

TEST(ViewedCharacterOfACrowd, IsNoneWhereNoAgentIsSelected) {
  const auto show = show_of(demo("--agents 4"));
  EXPECT_TRUE(take(ViewSelected{}, *show));
  EXPECT_EQ(show->viewer(), nullptr);
}

TEST(ViewedCharacterOfACrowd, GivesWayToTheFirstOfOthersThatCome) {
  const auto show = show_of(demo("--agents 4"));
  ASSERT_TRUE(show->open_viewer({}));
  const std::vector<std::string> files = {THRONG_SOURCE_DIR "/tests/data/features/plain.glb"};
  ASSERT_TRUE(show->take(LoadModels{files}));
  ASSERT_NE(show->viewer(), nullptr);
  EXPECT_EQ(&show->viewer()->viewed().source(), &show->stage().people().front());
  animate(*show, 2);
  show->leave_viewer();
  animate(*show, 2);
}

TEST(ViewOnTheCommandLine, BeginsWithTheClipThatItNames) {
  const auto show = show_of(demo("--agents 4 --view=walk"));
  ASSERT_NE(show->viewer(), nullptr);
  const auto& names = show->stage().people().front().clip_names;
  EXPECT_EQ(names[static_cast<std::size_t>(show->viewer()->settings().clip)], "walk");
}

TEST(ViewOnTheCommandLine, SaysWhichClipsComeNearest) {
  StartError error;
  EXPECT_EQ(open_show(demo("--agents 4 --view=wolk"), error), nullptr);
  EXPECT_NE(error.message.find("nearest are"), std::string::npos) << error.message;
}

TEST(PreviewOfARole, IsAppliedToTheCrowdOrNot) {
  const auto show = show_of(demo("--agents 40"));
  animate(*show, 5);
  const RoleClips before = show->stage().people().front().roles.clips;
  const int run = before[index_of(Role::run)];
  const View look{{.preview = RolePreview{Role::walk, run}}};
  ASSERT_TRUE(take(look, *show));
  EXPECT_EQ(show->viewer()->settings().clip, run) << "it plays what was chosen";
  EXPECT_EQ(show->stage().people().front().roles.clips, before) << "the crowd does not yet";
  ASSERT_TRUE(take(LeaveViewer{}, *show));
  EXPECT_EQ(show->stage().people().front().roles.clips, before);
  ASSERT_TRUE(take(look, *show));
  const auto roles = previewed_roles(*show);
  ASSERT_TRUE(take(ApplyPreview{}, *show));
  test::ask(*show, *roles);
  EXPECT_EQ(show->viewer(), nullptr);
  EXPECT_EQ(show->stage().people().front().roles.clips[index_of(Role::walk)], run);
}

}  // namespace
}  // namespace throng::app::viewing_test
