#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/c_coverage.h"
#include "tests/house/class_size.h"
#include "tests/house/house_rules.h"
#include "tests/house/includes.h"
#include "tests/house/maths_rules.h"
#include "tests/house/page_rules.h"

namespace throng::house::house_test {
namespace {

using testing::IsEmpty;

const Tree& project() {
  static const Tree tree = read_project(THRONG_SOURCE_DIR);
  return tree;
}

TEST(House, HasFilesInEveryRoom) { EXPECT_THAT(rooms_without_files(project()), IsEmpty()); }

TEST(House, TheProgramHasAtMostEightWings) {
  std::set<std::string> wings;
  for (const SourceFile& file : project()) {
    const std::filesystem::path within = std::filesystem::path(file.path).lexically_relative("app");
    if (file.path.starts_with("app/") && within.has_parent_path()) wings.insert(within.begin()->string());
  }
  EXPECT_THAT(wings, testing::SizeIs(testing::Le(8U)));
}

TEST(House, NoRoomIsTooFull) { EXPECT_THAT(rooms_too_full(project()), IsEmpty()); }

TEST(House, NoFileIncludesAHigherFloor) { EXPECT_THAT(includes_that_climb(project()), IsEmpty()); }

TEST(House, LibrariesMeetInAppAlone) { EXPECT_THAT(includes_that_join(project()), IsEmpty()); }

// The number sinks as the program takes the public headers instead; it never rises.
TEST(House, TheProgramSeesTheInsideOfTheLibraryInFewFiles) {
  std::set<std::string> files;
  for (const Include& include : includes_of(project(), "app/")) {
    if (include.target.starts_with("engine/anim/") && !include.target.starts_with("engine/anim/include/")) {
      files.insert(include.file->path);
    }
  }
  EXPECT_LE(files.size(), 87U);
}

TEST(House, PartsOfOthersAreSeenByFewFiles) { EXPECT_THAT(parts_seen_elsewhere(project()), IsEmpty()); }

TEST(House, FilesAreOpenedAndJsonIsParsedInOnePlace) { EXPECT_THAT(files_opened_elsewhere(project()), IsEmpty()); }

TEST(House, MainDoesNoMaths) { EXPECT_THAT(maths_in_main(project()), IsEmpty()); }

TEST(House, NoPoseDependsOnTheSystemsSines) { EXPECT_THAT(rounded_by_the_system(project()), IsEmpty()); }

TEST(House, NoFileIsTooLong) { EXPECT_THAT(files_too_long(project()), IsEmpty()); }

TEST(House, NoClassHasTooManyMethods) {
  EXPECT_THAT(classes_with_too_many_methods(project()), IsEmpty());
  std::vector<ClassSize> largest = class_sizes(project());
  largest.resize(std::min<std::size_t>(largest.size(), 12));
  for (const ClassSize& size : largest) {
    std::cout << size.name << ": " << size.public_methods << " public, " << size.private_methods
              << " private methods\n";
  }
}

TEST(House, AppSourcesTakeInFewHeaders) {
  std::vector<std::pair<std::size_t, std::string>> sources;
  for (const auto& [path, count] : own_headers_behind(project())) sources.emplace_back(count, path);
  std::ranges::sort(sources, std::greater{});
  const std::size_t median = sources[sources.size() / 2].first;
  std::cout << "own headers behind a source of app: " << median << " in the median; the most:\n";
  for (std::size_t i = 0; i < 6; ++i) std::cout << sources[i].second << ": " << sources[i].first << '\n';
  EXPECT_LE(median, 70U);
}

TEST(House, NoFunctionIsAFriendButOperators) { EXPECT_THAT(friends_that_are_methods(project()), IsEmpty()); }

TEST(House, CReachesEveryPublicFunctionOrSaysWhyNot) { EXPECT_THAT(c_coverage_gaps(project(), c_table()), IsEmpty()); }

TEST(House, StructsOfCHaveEveryMember) { EXPECT_THAT(c_struct_gaps(project(), c_structs()), IsEmpty()); }

TEST(House, NoFileNamesAPathOfOneMachine) { EXPECT_THAT(machine_paths(project()), IsEmpty()); }

TEST(House, TheProgramOfTheReadmeIsTheOneThatIsBuilt) {
  EXPECT_THAT(readme_program_that_differs(project()), IsEmpty());
}

TEST(House, EveryFolderOfTheEngineAndTheProgramSaysWhatItIs) {
  EXPECT_THAT(folders_without_readme(project()), IsEmpty());
}

TEST(House, TheFirstPageIsShort) { EXPECT_THAT(first_page_too_large(project()), IsEmpty()); }

TEST(House, EveryLinkLeadsSomewhere) {
  EXPECT_THAT(
      links_that_lead_nowhere(
          project(), [](const std::string& path) { return std::filesystem::exists(THRONG_SOURCE_DIR "/" + path); }),
      IsEmpty());
}

TEST(House, EveryFileToTryOfTheFirstPageIsThere) {
  EXPECT_THAT(
      files_to_try_that_are_missing(
          project(), [](const std::string& path) { return std::filesystem::exists(THRONG_SOURCE_DIR "/" + path); }),
      IsEmpty());
}

TEST(House, EverythingThatThePaperAsksForHasAFileAndATest) {
  EXPECT_THAT(paper_rows_without_file_or_test(project()), IsEmpty());
}

}  // namespace
}  // namespace throng::house::house_test
