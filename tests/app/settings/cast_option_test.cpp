#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/settings/option_values.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::cast_option_test {
namespace {

using testing::ElementsAre;

std::vector<CastEntry> taken(const std::string& text) {
  std::vector<CastEntry> entries;
  const Complaint complaint = cast_entries(entries)(text);
  EXPECT_FALSE(complaint) << *complaint;
  return entries;
}

std::string refusal(const std::string& text) {
  std::vector<CastEntry> entries;
  return cast_entries(entries)(text).value_or("(taken)");
}

TEST(CastOption, ReadsFilesFoldersSkinsAndShares) {
  EXPECT_THAT(taken("man.glb*3,woman.glb*2.5,child.glb"),
              ElementsAre(CastEntry{"man.glb", 3.0}, CastEntry{"woman.glb", 2.5}, CastEntry{"child.glb"}));
  EXPECT_THAT(taken("people*2,scene.glb#Knight*2,scene.glb#all"),
              ElementsAre(CastEntry{"people", 2.0}, CastEntry{"scene.glb#Knight", 2.0}, CastEntry{"scene.glb#all"}));
  EXPECT_THAT(taken("people/*2"), ElementsAre(CastEntry{"people/", 2.0}));
}

TEST(CastOption, RefusesSharesThatAreNoneAndSaysHowTheyAreWritten) {
  const std::string remedy = " must be a number, 0.01 to 10000, as in ";
  for (const char* const share : {"0", "-1", "x", "", "nan", "inf", "1e9", "2x"}) {
    EXPECT_EQ(refusal(std::string("a.glb,man.glb*") + share), "the share of man.glb" + remedy + "man.glb*2") << share;
  }
}

TEST(CastOption, RefusesEntriesWithoutAFile) {
  for (const char* const text : {"", "a.glb,", ",a.glb", "*3", "a.glb,,b.glb"}) {
    EXPECT_EQ(refusal(text), "must be FILE*SHARE, with commas between several; FILE may be a folder") << text;
  }
  std::string many = "0.glb";
  for (std::size_t i = 1; i <= most_models; ++i) many += "," + std::to_string(i) + ".glb";
  EXPECT_EQ(refusal(many), "must be 30 files and folders at most");
}

class CastOptionOnDisk : public test::TemporaryFolder {};

TEST_F(CastOptionOnDisk, TakesAFileWhoseNameEndsLikeAShareForThatFile) {
  const std::string odd = (folder_ / "odd*2").string();
  std::ofstream(odd) << "x";
  EXPECT_THAT(taken(odd), ElementsAre(CastEntry{odd}));
  EXPECT_THAT(taken(odd + "*3"), ElementsAre(CastEntry{odd, 3.0}));
}

}  // namespace
}  // namespace throng::app::cast_option_test
