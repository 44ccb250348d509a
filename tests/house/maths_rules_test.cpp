#include "tests/house/maths_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::house::maths_rules_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

Findings of_line(const std::string& line, const std::string& path = "engine/anim/asset/clip.cpp") {
  return rounded_by_the_system({source_file(path, "\n" + line + "\n")});
}

TEST(Maths, OfTheSystemAreRefusedInTheLibrary) {
  EXPECT_THAT(of_line("  x = std::sin(angle);"), ElementsAre(StartsWith("engine/anim/asset/clip.cpp:2:")));
  for (const char* const line :
       {"sinf(x)", "std::acos(x)", "1.0/tan(x)", "::atan2(y, x)", "std::log10(x)", "glm::pow(x, y)", "std::hypot(x, y)",
        "cbrt(x)", "std::exp(x)", "using glm::angleAxis;", "glm::slerp(a, b, t)", "glm::rotate(m, x, v)",
        "glm::eulerAngles(q)"}) {
    EXPECT_THAT(of_line(line), SizeIs(1)) << line;
  }
}

TEST(Maths, OfTheLibraryAndExactOnesAreFree) {
  for (const char* const line :
       {"sine(x)", "arc_cosine(x)", "angle_axis(x, v)", "cube_root(x)", "std::sqrt(x)", "std::remainder(x, y)",
        "glm::length(v)", "glm::normalize(q)", "// as std::sin(x)", "slot.log(text)", "crowd->pow(x)", "exposing(x)"}) {
    EXPECT_THAT(of_line(line), IsEmpty()) << line;
  }
}

TEST(Maths, OfTheSystemDecideWhereTheyMakeNoBitOfAPose) {
  EXPECT_THAT(of_line("std::log2(x)", "engine/anim/lod/lod_cost.h"), IsEmpty());
  EXPECT_THAT(of_line("std::sin(x)", "engine/anim/examples/own_step.cpp"), IsEmpty());
  EXPECT_THAT(of_line("std::sin(x)", "app/people/crowd/crowd.cpp"), IsEmpty());
}

}  // namespace
}  // namespace throng::house::maths_rules_test
