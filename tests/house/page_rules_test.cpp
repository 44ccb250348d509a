// The rules of pages bite: each is given a page that breaks it, beside one that does not.
#include "tests/house/page_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::house::page_rules_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

Findings broken_links(const std::string& text) {
  const Tree tree{source_file("app/README.md", text), source_file("README.md", "# Ours\n\n## How to, `now`\n")};
  return links_that_lead_nowhere(tree, [](const std::string& path) { return path == "app/lod"; });
}

TEST(FirstPage, HasAtMost180LinesOf120Characters) {
  const auto page = [](int lines, const std::string& line) {
    std::string text;
    for (int i = 0; i < lines; ++i) text += line + "\n";
    return Tree{source_file("README.md", text)};
  };
  std::string accents;
  for (int i = 0; i < 120; ++i) accents += "\xC3\xA9";
  EXPECT_THAT(first_page_too_large(page(180, accents)), IsEmpty());
  EXPECT_THAT(first_page_too_large(page(181, "a")), ElementsAre(StartsWith("README.md:181:")));
  EXPECT_THAT(first_page_too_large(page(1, std::string(121, 'a'))), ElementsAre(StartsWith("README.md:1:")));
}

TEST(FirstPage, NamesNoFileToReadThatIsMissing) {
  const auto missing = [](const std::string& line) {
    return files_to_try_that_are_missing(Tree{source_file("README.md", line + "\n")},
                                         [](const std::string& path) { return path == "assets/a.glb"; });
  };
  EXPECT_THAT(missing("`throng assets/a.glb*3` and `throng MODEL.glb --screenshot a.png`"), IsEmpty());
  EXPECT_THAT(missing("`throng fox.glb --trajectories b/walk.txt`"),
              ElementsAre("README.md:1: there is no fox.glb", "README.md:1: there is no b/walk.txt"));
}

TEST(Link, LeadsToAFileOrAFolder) {
  EXPECT_THAT(broken_links("[lod](lod)\n"), IsEmpty());
  EXPECT_THAT(broken_links("# App\n\n[a](attic) and ![b](lod.png)\n"),
              ElementsAre("app/README.md:3: a link leads nowhere: attic", StartsWith("app/README.md:3:")));
  EXPECT_THAT(broken_links("See [it][1].\n\n[1]: attic\n"), ElementsAre(StartsWith("app/README.md:3:")));
}

TEST(Link, LeadsToAHeadingWhereItNamesOne) {
  EXPECT_THAT(broken_links("# App\n[a](#app) [b](../README.md#how-to-now)\n"), IsEmpty());
  EXPECT_THAT(broken_links("[a](#attic) [b](../README.md#attic) [c](lod#lod)\n"), SizeIs(3));
}

TEST(Link, IsNotWhatLooksLikeOne) {
  EXPECT_THAT(broken_links("[a](https://example.org/b#c)\n```cpp\nauto f = [](int) {};\n```\n"), IsEmpty());
}

}  // namespace
}  // namespace throng::house::page_rules_test
