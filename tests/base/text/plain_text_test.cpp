#include "engine/base/text/plain_text.h"

#include <string>

#include <gtest/gtest.h>

namespace throng::plain_text_test {
namespace {

TEST(PlainText, LeavesOrdinaryNamesOfAnyScriptAsTheyAre) {
  for (const char* name :
       {"", "Armature|Walk.001", "mixamorig:Hips", "左腕", "Läuferin", "می‌روم", "👩‍🚀"}) {
    EXPECT_EQ(plain_text(name), name);
    EXPECT_TRUE(is_utf8(name)) << name;
  }
}

TEST(PlainText, IsOneLineWithoutEscapesOfTerminals) {
  EXPECT_EQ(plain_text("\x1B[31mIdle\x1B[0m"), "\uFFFD[31mIdle\uFFFD[0m");
  EXPECT_EQ(plain_text("two\nlines\r\tand"), "two lines  and");
  EXPECT_EQ(plain_text(std::string_view("a\0b", 3)), "a\uFFFDb");
  EXPECT_EQ(plain_text("\xC2\x9B"
                       "31m"),
            "\uFFFD31m")
      << "C1 controls begin escapes too";
}

TEST(PlainText, TurnsNoDirectionAndHidesNothing) {
  EXPECT_EQ(plain_text("\u202Eklaw\u200B"), "\uFFFDklaw\uFFFD");
  EXPECT_EQ(plain_text("\u2066a\u2069\uFEFF\u2028"), "\uFFFDa\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(plain_text("\U000E0041"), "\uFFFD") << "tags are invisible letters";
}

TEST(PlainText, ReplacesBytesThatAreNoUtf8) {
  for (const char* bytes : {"\xFC", "\xC3", "\xC0\xAF", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE2\x82"}) {
    EXPECT_FALSE(is_utf8(bytes));
    EXPECT_TRUE(is_utf8(plain_text(bytes)));
  }
  EXPECT_EQ(plain_text("M\xFCller"), "M\uFFFDller");
}

}  // namespace
}  // namespace throng::plain_text_test
