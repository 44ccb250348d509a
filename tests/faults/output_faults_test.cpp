// A disk that is full while pictures and labels are written: what is there is whole, and the run goes on later.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"
#include "tests/faults/jobs.h"

namespace throng::output_faults_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int frames = 3;

class OutputOnAFullDisk : public app::test::TemporaryFolder, public testing::WithParamInterface<int> {
 protected:
  OutputOnAFullDisk() {
    fs::create_directory(folder_ / "model");
    model_ = test::jobs_in(folder_ / "model").front().arguments.front();
  }

  app::ProgramRun run(const std::string& fault) const {
    return app::run_program(
        {model_, "--headless=" THRONG_HEADLESS, "--agents", "2", "--frames", std::to_string(frames), "--size", "64x64",
         "--msaa", "0", "--shadows", "off", "--pictures", (folder_ / "pictures").string(), "--labels",
         (folder_ / "labels").string()},
        {.seconds = 40, .program = THRONG_FAULTY_PROGRAM, .environment = {"THRONG_FAULT=" + fault}});
  }

  static std::string contents(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }

  void expect_whole_pictures() const {
    for (const char* const name : {"pictures", "labels"}) {
      if (!fs::exists(folder_ / name)) continue;
      for (const auto& entry : fs::directory_iterator(folder_ / name)) {
        const std::string bytes = contents(entry.path());
        if (entry.path().extension() == ".png") {
          EXPECT_TRUE(bytes.ends_with(std::string_view("IEND\xAE\x42\x60\x82"))) << entry.path();
        }
        if (entry.path().extension() == ".json") {
          EXPECT_TRUE(bytes.ends_with("}\n")) << entry.path();
        }
      }
    }
  }

  std::string model_;
};

TEST_P(OutputOnAFullDisk, EndsInOneLineAndGoesOnLater) {
  const app::ProgramRun full = run("write:" + std::to_string(GetParam()) + "+");
  EXPECT_EQ(full.exit_status, 1);
  EXPECT_THAT(full.errors, HasSubstr(": cannot be written: "));  // to write fails, or to see it onto the disk
  EXPECT_EQ(std::ranges::count(full.errors, '\n'), 1) << full.errors;
  expect_whole_pictures();
  const app::ProgramRun later = run("none");
  EXPECT_EQ(later.exit_status, 0) << later.errors;
  expect_whole_pictures();
  const std::string lines = contents(folder_ / "labels" / "labels.jsonl");
  EXPECT_EQ(std::ranges::count(lines, '\n'), frames);
  const auto files = [&](const char* name) {
    return std::distance(fs::directory_iterator(folder_ / name), fs::directory_iterator());
  };
  EXPECT_EQ(files("pictures"), frames + 1);
  EXPECT_EQ(files("labels"), 2 * frames + 3);
}

// The first writes are notes of the run, the later ones pictures and labels.
INSTANTIATE_TEST_SUITE_P(AtAWrite, OutputOnAFullDisk, testing::Values(1, 2, 3, 4, 6, 9, 12));

}  // namespace
}  // namespace throng::output_faults_test
