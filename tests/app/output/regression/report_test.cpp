#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/output/regression/junit.h"
#include "app/output/regression/markup.h"
#include "app/output/regression/origin.h"
#include "app/output/regression/page.h"
#include "engine/base/files/input_file.h"
#include "tests/app/output/regression/strict_xml.h"
#include "tests/own_folder.h"

namespace throng::app::report_test {
namespace {

using testing::HasSubstr;
using testing::Not;

CaseOutcome outcome(const std::string& name, Verdict verdict, const std::string& message = {}) {
  CaseOutcome result;
  result.name = name;
  result.context = "egl";
  result.verdict = verdict;
  result.message = message;
  result.seconds = 1.5;
  return result;
}

RegressionRun one_of_each() {
  return {.title = "mine",
          .outcomes = {outcome("good", Verdict::passed),
                       outcome("bad", Verdict::failed, "a < b & \"c\"\nand \x01 a bell\xFF"),
                       outcome("broken", Verdict::not_drawn, "no model"),
                       outcome("absent", Verdict::left_out, "no OSMesa"), outcome("new", Verdict::added)}};
}

TEST(StrictXml, RefusesWhatIsNotWellFormed) {
  const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  EXPECT_TRUE(test::parse_strictly(head + "<a b=\"c\"><d/>e&amp;</a>\n"));
  for (const char* const wrong : {"<a>\n", "<a></b>\n", "<a b=c/>\n", "<a b=\"<\"/>\n", "<a>&</a>\n", "<a>&nbsp;</a>\n",
                                  "<a b=\"\" b=\"\"/>\n", "<a/><b/>\n", "<a>\x01</a>\n"}) {
    EXPECT_FALSE(test::parse_strictly(head + wrong)) << wrong;
  }
}

TEST(JUnit, IsWellFormedAndCounts) {
  const auto xml = test::parse_strictly(junit_xml(one_of_each()));
  ASSERT_TRUE(xml) << junit_xml(one_of_each());
  ASSERT_EQ(xml->children.size(), 1U);
  const test::XmlElement& suite = xml->children[0];
  EXPECT_EQ(suite.attributes.at("name"), "mine");
  for (const test::XmlElement* const each : {&*xml, &suite}) {
    EXPECT_EQ(each->attributes.at("tests"), "5");
    EXPECT_EQ(each->attributes.at("failures"), "1");
    EXPECT_EQ(each->attributes.at("errors"), "1");
    EXPECT_EQ(each->attributes.at("skipped"), "1");
    EXPECT_EQ(each->attributes.at("time"), "7.500");
  }
  ASSERT_EQ(suite.children.size(), 5U);
  EXPECT_TRUE(suite.children[0].children.empty());
  EXPECT_EQ(suite.children[1].attributes.at("classname"), "mine.egl");
  EXPECT_EQ(suite.children[1].children.at(0).name, "failure");
  EXPECT_THAT(suite.children[1].children.at(0).attributes.at("message"), HasSubstr("a < b & \"c\" and"));
  EXPECT_EQ(suite.children[2].children.at(0).name, "error");
  EXPECT_EQ(suite.children[3].children.at(0).name, "skipped");
}

TEST(Summary, NamesTheKindsThatThereAre) {
  EXPECT_EQ(summary_of(one_of_each()), "5 pictures: 1 as expected, 1 new, 1 failed, 1 not drawn, 1 left out");
  EXPECT_EQ(summary_of({.title = "", .outcomes = {outcome("good", Verdict::passed)}}), "1 picture: 1 as expected");
}

TEST(Base64, IsAsTheStandardHasIt) {
  const auto encoded = [](std::string_view text) { return in_base64(std::as_bytes(std::span(text))); };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("\xFB\xFF\xBF"), "+/+/");
}

std::string inline_picture(const std::filesystem::path& file) {
  const auto bytes = read_file(file, "a .png", 1U << 20U);
  return "data:image/png;base64," + in_base64(std::as_bytes(std::span(*bytes)));
}

std::string page_of(const RegressionRun& run, const std::filesystem::path& folder) {
  EXPECT_TRUE(write_page(run, folder / "page.html"));
  return *read_text(folder / "page.html", "a page", 1U << 24U);
}

TEST(Page, HasItsPicturesInsideAndNeedsNothingElse) {
  const throng::test::OwnFolder folder;
  CaseOutcome bad = outcome("bad", Verdict::failed, "it differs");
  bad.differs = true;
  for (const auto& [file, name, width] : {std::tuple{&bad.expected, "e.png", 3}, std::tuple{&bad.actual, "a.png", 4},
                                          std::tuple{&bad.difference, "d.png", 5}, std::tuple{&bad.heat, "h.png", 6}}) {
    *file = folder.path() / name;
    ASSERT_TRUE(render::write_png(render::Image::blank(width, 2), *file));
  }
  bad.figures = judge({.mean = 1}, {});
  const std::string page =
      page_of({.title = "<mine>", .outcomes = {outcome("good", Verdict::passed), bad}}, folder.path());
  for (const auto* const file : {&bad.expected, &bad.actual, &bad.difference, &bad.heat}) {
    EXPECT_THAT(page, HasSubstr(inline_picture(*file)));
  }
  EXPECT_THAT(page, HasSubstr("<title>&lt;mine&gt;: 2 pictures: 1 as expected, 1 failed</title>"));
  EXPECT_THAT(page, HasSubstr("type=\"range\""));
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_LT(page.find("it differs"), page.find(">good<")) << "what failed comes first";
}

TEST(Page, ShowsTheSamePictureOnce) {
  const throng::test::OwnFolder folder;
  CaseOutcome good = outcome("good", Verdict::passed);
  good.expected = good.actual = folder.path() / "a.png";
  ASSERT_TRUE(render::write_png(render::Image::blank(4, 4), good.actual));
  good.figures = judge({}, {});
  const std::string page = page_of({.title = "mine", .outcomes = {good}}, folder.path());
  const std::size_t first = page.find("data:image/png");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(page.find("data:image/png", first + 1), std::string::npos);
}

TEST(Origin, ComesBackOutOfAPicture) {
  const throng::test::OwnFolder folder;
  const auto file = folder.path() / "a.png";
  const DrawnBy drawn_by{
      .context = "egl", .gl_version = "4.5 (Core Profile) Mesa 22.3.6", .gl_renderer = "llvm\xC3\xA9pipe"};
  ASSERT_TRUE(render::write_png(render::Image::blank(4, 4), file, origin_texts(drawn_by)));
  const PictureOrigin origin = read_origin(file);
  EXPECT_THAT(origin.program, testing::StartsWith("Throng "));
  EXPECT_THAT(origin.program, HasSubstr(", commit "));
  EXPECT_EQ(origin_text(origin), "egl, llvm??pipe, Mesa 22.3.6");
}

TEST(Origin, ThatIsAnotherIsNamedWhereItDiffers) {
  const PictureOrigin old{.program = "", .context = "egl", .renderer = "llvmpipe", .gl_version = "Mesa 21.0"};
  PictureOrigin now = old;
  now.program = "Throng of another commit";
  EXPECT_EQ(other_origin(old, now), "");
  EXPECT_EQ(other_origin({}, now), "");
  now.gl_version = "Mesa 22.3.6";
  EXPECT_EQ(other_origin(old, now), "the expected picture was made by Mesa 21.0, not Mesa 22.3.6");
}

}  // namespace
}  // namespace throng::app::report_test
