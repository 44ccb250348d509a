// throng check over a folder with a passing, a failing, a missing, a damaged and a wrongly sized expected picture.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "throng/render/context.h"
#include "throng/render/image.h"

#include "app/output/regression/compare.h"
#include "app/output/regression/markup.h"
#include "app/output/regression/origin.h"
#include "engine/base/files/input_file.h"
#include "tests/app/output/regression/strict_xml.h"
#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::gl_check_test {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> contexts() {
  if (!render::gl::osmesa_is_installed()) return {"egl"};
  return {"egl", "osmesa"};
}

std::string text_of(const fs::path& file) {
  const auto text = read_text(file, "a file", 1U << 26U);
  return text ? *text : std::string();
}

class Check : public test::TemporaryFolder, public testing::WithParamInterface<std::string> {
 protected:
  Check() {
    std::ofstream(folder_ / "cases.json") << R"({
      "defaults": {"scene": "grid", "agents": 1, "frame": 1, "size": "96x64", "options": ["--scenery", "off"]},
      "cases": [{"name": "good"}, {"name": "other"}, {"name": "missing"}, {"name": "damaged"}, {"name": "small"}]})";
  }
  ProgramRun check(std::vector<std::string> more) const {
    more.insert(more.begin(), {"check", folder_ / "cases.json", "--out", folder_ / "out", "--context", GetParam()});
    return run_program(more);
  }
  fs::path expected(const std::string& name) const { return folder_ / "expected" / (name + ".png"); }

  /// Makes the expected picture of the first case, and of it those of the others.
  void make_expected() const {
    const ProgramRun made = check({"--case", "good", "--update"});
    ASSERT_EQ(made.exit_status, 0) << made.errors << made.output;
    EXPECT_THAT(made.output, StartsWith("new       good (" + GetParam() + "): " + expected("good").string() + "\n"));
    auto picture = render::read_png(expected("good"));
    ASSERT_TRUE(picture);
    for (int y = 20; y < 36; ++y) {
      for (int x = 40; x < 56; ++x) picture->pixel(x, y)[0] ^= 0xFF;
    }
    PictureOrigin origin = read_origin(expected("good"));
    origin.gl_version = "4.5 (Core Profile) Mesa 1.2.3";
    ASSERT_TRUE(render::write_png(*picture, expected("other"), texts_of(origin)));
    ASSERT_TRUE(render::write_png(render::Image::blank(32, 32), expected("small")));
    std::ofstream(expected("damaged")) << text_of(expected("good")).substr(0, 300);
  }

  std::string line_of(const std::string& name, const std::string& output) const {
    const std::size_t at = output.find(" " + name + " (" + GetParam() + ")");
    const std::size_t from = output.rfind('\n', at) + 1;
    return at == std::string::npos ? "no line" : output.substr(from, output.find('\n', at) - from);
  }
};

TEST_P(Check, TellsWhatIsWrongWithEachPictureAndReportsAll) {
  make_expected();
  const ProgramRun run = check({"--junit", folder_ / "j.xml", "--report", folder_ / "r.html"});
  EXPECT_EQ(run.exit_status, 1) << run.errors;
  EXPECT_THAT(line_of("good", run.output), EndsWith(": no pixel differs"));
  EXPECT_THAT(line_of("other", run.output), StartsWith("FAILED    other (" + GetParam() +
                                                       "): the expected picture was made by "
                                                       "4.5 (Core Profile) Mesa 1.2.3, not 4."));
  EXPECT_THAT(line_of("other", run.output), HasSubstr("; mean "));
  EXPECT_THAT(line_of("missing", run.output),
              HasSubstr("there is no expected picture " + expected("missing").string()));
  EXPECT_THAT(line_of("missing", run.output), EndsWith(" --case missing --update"));
  EXPECT_THAT(line_of("damaged", run.output), HasSubstr("cannot read image " + expected("damaged").string() + ": "));
  EXPECT_THAT(line_of("small", run.output), EndsWith(": the sizes differ: 32x32 expected, 96x64 drawn"));
  EXPECT_THAT(run.errors,
              HasSubstr("throng: 5 pictures: 1 as expected, 4 failed; see " + (folder_ / "r.html").string() + "\n"));

  const auto xml = test::parse_strictly(text_of(folder_ / "j.xml"));
  ASSERT_TRUE(xml) << text_of(folder_ / "j.xml");
  EXPECT_EQ(xml->attributes.at("tests"), "5");
  EXPECT_EQ(xml->attributes.at("failures"), "4");
  EXPECT_EQ(xml->attributes.at("errors"), "0");

  for (const fs::path& file : {expected("good"), folder_ / "out" / ("good-" + GetParam() + "-actual.png")}) {
    const PictureOrigin origin = read_origin(file);
    EXPECT_THAT(origin.program, HasSubstr(", commit ")) << file;
    EXPECT_EQ(origin.context, GetParam()) << file;
    EXPECT_THAT(origin.renderer, HasSubstr("llvmpipe")) << file;
    EXPECT_NE(mesa_version(origin.gl_version), "") << file;
  }

  const std::string page = text_of(folder_ / "r.html");
  const std::string before = "other-" + GetParam() + "-";
  for (const fs::path& file :
       {expected("other"), folder_ / "out" / (before + "actual.png"), folder_ / "out" / (before + "difference.png"),
        folder_ / "out" / (before + "heat.png"), expected("small")}) {
    const std::string bytes = text_of(file);
    ASSERT_NE(bytes, "") << file;
    EXPECT_NE(page.find(in_base64(std::as_bytes(std::span(bytes)))), std::string::npos) << file;
  }
}

// Without git, what --update replaces is gone; so it asks.
TEST_P(Check, UpdatesWhatNobodyKeepsOnlyByForce) {
  fs::create_directory(folder_ / "expected");
  std::ofstream(expected("good")) << "mine";
  const ProgramRun refused = check({"--case", "good", "--update"});
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_THAT(refused.errors, EndsWith("; --force replaces them all the same\n"));
  EXPECT_EQ(text_of(expected("good")), "mine");
  const ProgramRun forced = check({"--case", "good", "--update", "--force"});
  EXPECT_EQ(forced.exit_status, 0) << forced.errors;
  EXPECT_THAT(forced.output, StartsWith("changed   good"));
  const std::string bytes = text_of(expected("good"));
  const ProgramRun again = check({"--case", "good", "--update", "--force"});
  EXPECT_THAT(again.output, StartsWith("same      good"));
  EXPECT_EQ(text_of(expected("good")), bytes);
}

INSTANTIATE_TEST_SUITE_P(Contexts, Check, testing::ValuesIn(contexts()), [](const auto& run) { return run.param; });

}  // namespace
}  // namespace throng::app::gl_check_test
