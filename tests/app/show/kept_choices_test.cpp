#include "app/show/kept_choices.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::kept_choices_test {
namespace {

using KeptChoices = test::TemporaryFolder;

TEST_F(KeptChoices, LieBesideTheModelAndAreTakenByTheNextRun) {
  const std::filesystem::path model = folder_ / "person.glb";
  std::filesystem::copy_file(THRONG_SOURCE_DIR "/assets/mannequin.glb", model);
  const DemoOptions options = test::demo("--agents 2 " + model.string());
  RoleClips clips;
  {
    const auto show = test::show_of(options);
    clips = show->stage().characters()[0].roles.clips;
    clips[index_of(Role::walk)] = clips[index_of(Role::run)];
    EXPECT_TRUE(show->take(SetRoles{0, clips}));
    for (const auto& kept : {save_roles(show->stage().characters()[0]), save_bone_lod(show->stage().characters()[0]),
                             export_lod(*show, 0)}) {
      ASSERT_TRUE(kept);
      EXPECT_EQ(kept->parent_path(), folder_);
      EXPECT_TRUE(std::filesystem::exists(*kept)) << *kept;
    }
  }
  EXPECT_EQ(test::show_of(options)->stage().characters()[0].roles.clips, clips);
}

class LodExportOfAShow : public KeptChoices {
 protected:
  /// Returns what is exported with a tuning, once a frame was posed with it.
  std::string with(const std::function<void(Tuning&)>& change) {
    Tuning tuning = show_->stage().tuning();
    change(tuning);
    EXPECT_TRUE(show_->take(Apply{tuning}));
    show_->animate(test::sixtieth);
    const auto written = export_lod(*show_, 0);
    EXPECT_TRUE(written);
    std::ostringstream text;
    text << std::ifstream(*written).rdbuf();
    return text.str();
  }
  void SetUp() override {
    KeptChoices::SetUp();
    std::filesystem::copy_file(THRONG_SOURCE_DIR "/assets/mannequin.glb", folder_ / "person.glb");
    show_ = test::show_of(test::demo("--agents 20 " + (folder_ / "person.glb").string()));
  }

  std::unique_ptr<Show> show_;
};

TEST_F(LodExportOfAShow, FollowsEveryValueThatIsInForceAndNoOther) {
  struct Value {
    const char* name;
    std::function<void(Tuning&)> change;
    std::vector<LodRule> in_force;
  };
  const std::vector<Value> values{
      {"error", [](Tuning& tuning) { tuning.error_px = 0.25F; }, {LodRule::budget}},
      {"full rate to", [](Tuning& tuning) { tuning.lod.full_rate_distance = 5; }, {LodRule::distance}},
      {"one more each", [](Tuning& tuning) { tuning.lod.interval_growth = 5; }, {LodRule::distance}},
      {"level distance", [](Tuning& tuning) { tuning.lod.level_distances[0] = 5; }, {LodRule::off, LodRule::distance}},
      {"longest", [](Tuning& tuning) { tuning.lod.largest_interval = 3; }, {LodRule::distance, LodRule::budget}},
      {"bones",
       [](Tuning& tuning) { tuning.lod.bone_lod = false; },
       {LodRule::off, LodRule::distance, LodRule::budget}},
      {"smooth", [](Tuning& tuning) { tuning.lod.smooth = false; }, {LodRule::distance, LodRule::budget}},
      {"mesh", [](Tuning& tuning) { tuning.mesh_lod = 1; }, {LodRule::off, LodRule::distance, LodRule::budget}},
      {"seed", [](Tuning& tuning) { tuning.seed = 5; }, {}}};
  for (const LodRule rule : {LodRule::off, LodRule::distance, LodRule::budget}) {
    const Tuning before{.lod = {.rule = rule, .smooth = true}};
    const std::string standard = with([&](Tuning& tuning) { tuning = before; });
    for (const Value& value : values) {
      const std::string changed = with([&](Tuning& tuning) { value.change(tuning = before); });
      const bool in_force = std::ranges::find(value.in_force, rule) != value.in_force.end();
      EXPECT_EQ(changed != standard, in_force) << value.name << " by rule " << static_cast<int>(rule);
    }
    EXPECT_EQ(with([&](Tuning& tuning) { tuning = before; }), standard) << "the same values export the same";
  }
}

}  // namespace
}  // namespace throng::app::kept_choices_test
