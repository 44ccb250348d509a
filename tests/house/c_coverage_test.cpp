#include "tests/house/c_coverage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::house::c_coverage_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string headers = "engine/anim/include/throng/";

/// Two headers for C++ and one for C.
Tree tree() {
  return {
      source_file(headers + "bird.h",
                  "namespace throng {\nnamespace detail {\nint hidden();\n}\nstruct Egg { void (*hatch)(int a); };\n"
                  "class Bird {\n public:\n  explicit Bird(int a) : a_(a) {}\n  bool operator==(const Bird&) const;\n"
                  "  class Wing wing() const;\n  template <typename T>\n  void sing(T&& song) const { song(); }\n"
                  " private:\n  int sleep();\n};\n}\n"),
      source_file(headers + "nest.h", "namespace throng {\nResult<Bird> find(const Nest& nest = {});  // look()\n}\n"),
      source_file(headers + "c/bird.h",
                  "#define THRONG_DEFAULT(NAME) \\\n  THRONG_C int NAME##_fill(NAME* into);\n"
                  "THRONG_DEFAULT(throng_egg)\nTHRONG_C void throng_bird_sing(throng_bird* bird,\n  int song);\n")};
}

const std::vector<CoverageRow> whole{{"Bird::sing", {"throng_bird_sing"}},
                                     {"Bird::wing", {}, "A bird of C has no parts."},
                                     {"find", {}, "C finds none."}};

TEST(CCoverage, IsWholeIfEachFunctionHasARow) { EXPECT_THAT(c_coverage_gaps(tree(), whole), IsEmpty()); }

TEST(CCoverage, NamesFunctionsWithoutARow) {
  EXPECT_THAT(
      c_coverage_gaps(tree(), {{"Bird::wing", {}, "No parts."}}),
      ElementsAre("Bird::sing has no row in the table of C and C++", "find has no row in the table of C and C++",
                  "throng_bird_sing has no row in the table of C and C++"));
}

TEST(CCoverage, NamesRowsWhoseFunctionsAreGone) {
  std::vector<CoverageRow> table = whole;
  table.push_back({"Bird::sleep", {"throng_bird_sleep"}});
  EXPECT_THAT(c_coverage_gaps(tree(), table), ElementsAre("Bird::sleep is no function of the headers for C++",
                                                          "throng_bird_sleep is no function of the headers for C"));
}

TEST(CCoverage, AsksForAReasonWhereOneSideIsEmpty) {
  std::vector<CoverageRow> table = whole;
  table[2].why.clear();
  EXPECT_THAT(c_coverage_gaps(tree(), table), ElementsAre("find stands alone without a reason"));
}

TEST(CStructs, HaveTheMembersOfThoseOfCpp) {
  const Tree eggs{source_file(headers + "egg.h",
                              "struct Egg {\n  float size = 1.0F;  ///< big\n  std::array<int, 2> spots{1, 2};\n"
                              "  void (*hatch)(int day) = nullptr;\n  int count() const;\n  Vec3 colour{};\n};\n"),
                  source_file(headers + "c/egg.h",
                              "/* struct throng_egg { */\ntypedef struct throng_egg {\n  float size; /* int shade; */\n"
                              "  int dots[2];\n} throng_egg;\n")};
  EXPECT_THAT(c_struct_gaps(eggs, {{"Egg", "throng_egg", {{"spots", "dots"}}}}),
              ElementsAre("Egg::hatch has no member in throng_egg", "Egg::colour has no member in throng_egg"));
  EXPECT_THAT(c_struct_gaps(eggs, {{"Nest", "throng_nest"}}),
              ElementsAre("Nest is no struct of the headers for C++", "throng_nest is no struct of the headers for C"));
}

}  // namespace
}  // namespace throng::house::c_coverage_test
