#include "app/show/kept_choices.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/app/recording/recorded_run.h"

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
    show->set_roles(0, clips);
    for (const auto& kept : {save_roles(show->stage().characters()[0]), save_bone_lod(show->stage().characters()[0]),
                             export_lod(*show, 0)}) {
      ASSERT_TRUE(kept);
      EXPECT_EQ(kept->parent_path(), folder_);
      EXPECT_TRUE(std::filesystem::exists(*kept)) << *kept;
    }
  }
  EXPECT_EQ(test::show_of(options)->stage().characters()[0].roles.clips, clips);
}

}  // namespace
}  // namespace throng::app::kept_choices_test
