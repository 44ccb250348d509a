#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/house_rules.h"

namespace throng::house {
namespace {

using testing::IsEmpty;

const Tree& project() {
  static const Tree tree = read_project(THRONG_SOURCE_DIR);
  return tree;
}

/// What climbs until it is moved: the layout of a pose belongs into base/, baking and characters into bake/.
bool is_to_be_moved(const std::string& finding) {
  return finding.starts_with("engine/anim/asset/bake") || finding.starts_with("engine/anim/asset/character") ||
         finding.find("includes engine/anim/kernel/pose.h:") != std::string::npos;
}

TEST(House, HasFilesOnEveryFloor) {
  for (const char* const room : {"base", "asset", "kernel", "entity", "run", "agent", "import"}) {
    const std::string folder = std::string("engine/anim/") + room + "/";
    EXPECT_TRUE(std::any_of(project().begin(), project().end(), [&](const SourceFile& file) {
      return file.path.starts_with(folder);
    })) << folder;
  }
}

TEST(House, NoFileIncludesAHigherFloor) {
  Findings findings = includes_that_climb(project());
  std::erase_if(findings, is_to_be_moved);
  EXPECT_THAT(findings, IsEmpty());
}

TEST(House, AnimationAndDrawingMeetInAppAlone) {
  EXPECT_THAT(includes_across_animation_and_drawing(project()), IsEmpty());
}

TEST(House, PartsOfOthersAreSeenByFewFiles) { EXPECT_THAT(parts_seen_elsewhere(project()), IsEmpty()); }

TEST(House, MainDoesNoMaths) { EXPECT_THAT(maths_in_main(project()), IsEmpty()); }

TEST(House, NoFileIsTooLong) { EXPECT_THAT(files_too_long(project()), IsEmpty()); }

TEST(House, NoFileNamesAPathOfOneMachine) { EXPECT_THAT(machine_paths(project()), IsEmpty()); }

TEST(House, TheProgramOfTheReadmeIsTheOneThatIsBuilt) {
  EXPECT_THAT(readme_program_that_differs(project()), IsEmpty());
}

TEST(House, EveryFolderOfTheEngineSaysWhatItIs) { EXPECT_THAT(folders_without_readme(project()), IsEmpty()); }

TEST(House, EverythingThatThePaperAsksForHasAFileAndATest) {
  EXPECT_THAT(paper_rows_without_file_or_test(project()), IsEmpty());
}

}  // namespace
}  // namespace throng::house
