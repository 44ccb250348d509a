// What requests bring from files is loaded ahead of them.
#include "app/show/load_plan.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"
#include "tests/tracks/track_file.h"

namespace throng::app::load_plan_test {
namespace {

using testing::HasSubstr;

const std::string model = THRONG_SOURCE_DIR "/tests/data/features/plain.glb";
const LoadProgress silent = [](double, const std::string&) {};

class PlanToLoad : public testing::Test {
 protected:
  LoadPlan plan_for(const CrowdRequest& request) const { return show_->plan_for({&request, 1}); }

  const std::unique_ptr<Show> show_ = test::show_of(test::demo("--agents 3"));
};

TEST_F(PlanToLoad, IsEmptyWhereARequestBringsNoFile) {
  EXPECT_TRUE(plan_for(Select{1}).is_empty());
  EXPECT_TRUE(plan_for(Apply{show_->stage().tuning()}).is_empty());
  EXPECT_TRUE(plan_for(SetPlacement{7, {}}).is_empty()) << "there is no such character";
}

TEST_F(PlanToLoad, NamesTheFileOrTheCharacter) {
  EXPECT_EQ(plan_for(LoadModels{{model}}).name(), model);
  EXPECT_EQ(plan_for(SetCast{{ChosenCharacter{.file = model}}}).name(), model);
  EXPECT_EQ(plan_for(SetPlacement{0, {.scale = 2.0}}).name(), "mannequin (built in)");
}

TEST_F(PlanToLoad, BringsTheCharactersOfItsRequestWithoutAnotherLookAtTheFile) {
  const TrackFolder folder;
  const std::string copy = folder.file("copy.glb", "");
  std::filesystem::copy_file(model, copy, std::filesystem::copy_options::overwrite_existing);
  auto loaded = load(plan_for(LoadModels{{copy}}), silent);
  ASSERT_TRUE(loaded) << loaded.error().message;
  std::filesystem::remove(copy);
  show_->take_ahead(std::move(loaded->casts));
  EXPECT_TRUE(show_->take(LoadModels{{copy}}));
  EXPECT_EQ(show_->stage().people().front().file, copy);
}

TEST_F(PlanToLoad, PlacesACharacterAnew) {
  auto loaded = load(plan_for(SetPlacement{0, {.scale = 2.0}}), silent);
  ASSERT_TRUE(loaded) << loaded.error().message;
  show_->take_ahead(std::move(loaded->casts));
  EXPECT_TRUE(show_->take(SetPlacement{0, {.scale = 2.0}}));
  EXPECT_EQ(show_->stage().people().front().placement.choice.scale, 2.0);
}

TEST_F(PlanToLoad, BuildsTheSurfacesThatADeviceCopies) {
  LoadPlan plan = plan_for(LoadModels{{model}});
  EXPECT_FALSE(plan.is_drawn) << "this show draws nothing";
  plan.is_drawn = true;
  const auto loaded = load(plan, silent);
  ASSERT_TRUE(loaded);
  EXPECT_FALSE(loaded->casts.front().characters.front().surface.bytes.empty());
}

TEST_F(PlanToLoad, TellsHowFarItIsAndEndsWhereItsProgressThrows) {
  const TrackFolder folder;
  double last = 0, last_of_tracks = 0;
  LoadPlan plan = plan_for(LoadModels{{model}});
  plan.tracks = folder.file("walk.csv", "id,time,x,y\n1,0,0,0\n1,1,1,0\n");
  plan.is_drawn = true;
  const auto loaded = load(plan, [&](double share, const std::string& what) {
    EXPECT_GE(share, last) << what;
    last = share;
    if (what == plan.tracks) last_of_tracks = share;
  });
  ASSERT_TRUE(loaded) << loaded.error().message;
  ASSERT_NE(loaded->tracks, nullptr);
  EXPECT_EQ(loaded->tracks->persons.size(), 1U);
  EXPECT_GT(last_of_tracks, 0.5) << "the model is the first of two parts";
  EXPECT_LE(last_of_tracks, 1.0);
  EXPECT_THROW((void)load(plan, [](double, const std::string&) { throw 1; }), int);
}

TEST_F(PlanToLoad, SaysWhatCannotBeRead) {
  const auto missing = load(plan_for(LoadModels{{"nothing.glb"}}), silent);
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("nothing.glb"));
  const auto nobody = load(plan_for(SetCast{}), silent);
  ASSERT_FALSE(nobody);
  EXPECT_THAT(nobody.error().message, HasSubstr("a crowd has 1 to"));
}

}  // namespace
}  // namespace throng::app::load_plan_test
