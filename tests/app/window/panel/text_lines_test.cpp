#include "app/window/panel/controls/text_lines.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace throng::app::text_lines_test {
namespace {

/// Each byte is as wide as the other.
float bytes(std::string_view text) { return static_cast<float>(text.size()); }

std::string lines(float width, const std::string& text) { return in_lines(bytes, width, text); }

TEST(TextLines, EndAtABlankAndNeverInANumberOrAName) {
  EXPECT_EQ(lines(12, "animation 6.78 ms"), "animation\n6.78 ms");
  EXPECT_EQ(lines(14, "the bone hand.r moves"), "the bone\nhand.r moves");
  EXPECT_EQ(lines(9, "of 1,234,567 agents"), "of\n1,234,567\nagents");
  EXPECT_EQ(lines(100, "one two"), "one two");
}

TEST(TextLines, AreNeverWiderThanTheirWidth) {
  const std::string text = "Wrote /a/folder/with/a/long/name/throng-1.png, a picture of 1,280 by 720 pixels.";
  for (float width = 1; width < 90; ++width) {
    std::istringstream all(lines(width, text));
    for (std::string line; std::getline(all, line);) EXPECT_LE(bytes(line), width) << line;
  }
}

TEST(TextLines, OfAPathEndBehindASlash) { EXPECT_EQ(lines(12, "/one/two/three"), "/one/two/\nthree"); }

TEST(TextLines, KeepLineEndsAndBlanks) {
  EXPECT_EQ(lines(40, "one\n\ntwo   three"), "one\n\ntwo   three");
  EXPECT_EQ(lines(40, ""), "");
}

TEST(CutText, EndsInDotsAndInNoPartOfALetter) {
  const std::string name = "M\xC3\xA4nner_mit_H\xC3\xBCten.glb";
  EXPECT_EQ(cut_to(bytes, bytes(name), name), name);
  EXPECT_EQ(cut_to(bytes, 6, name), "M\xC3\xA4...");
  EXPECT_EQ(cut_to(bytes, 5, name), "M...") << "the next letter has two bytes";
}

TEST(ThingsKeptApart, StandWhereTheyAreWantedIfTheyHaveRoom) {
  EXPECT_EQ(apart(std::vector{80.0F, 40.0F, 0.0F}, 13, 0, 100), (std::vector{80.0F, 40.0F, 0.0F}));
}

TEST(ThingsKeptApart, NeverLieOverEachOtherNorLeaveTheirRange) {
  for (const std::vector<float>& wanted :
       {std::vector{0.0F, 83.0F, 84.0F, 82.0F}, {0, 0, 0, 0}, {90, 90, 90}, {0, 5, 84}}) {
    std::vector<float> places = apart(wanted, 13, -6, 97);
    std::ranges::sort(places);
    EXPECT_GE(places.front(), -6);
    EXPECT_LE(places.back() + 13, 97);
    for (std::size_t i = 1; i < places.size(); ++i) EXPECT_GE(places[i] - places[i - 1], 13 - 1e-3F);
  }
}

}  // namespace
}  // namespace throng::app::text_lines_test
