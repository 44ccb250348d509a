// These tests let the n-th call of a kind fail in the real program, and walk n through load, work, save and quit.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"
#include "tests/faults/jobs.h"
#include "tests/faulty_program/faults.h"

namespace throng::injected_faults_test {
namespace {

namespace fs = std::filesystem;
using app::ProgramRun;
using test::Job;

constexpr std::string_view old_contents = "This was here before.";

std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Returns how many calls of each kind of each job fail: few in every test run, more where THRONG_FAULTS says so.
std::uint64_t faults_of_a_kind(bool draws) {
  const char* const asked = std::getenv("THRONG_FAULTS");
  const std::uint64_t usual = draws ? 1 : 2;  // drawing takes a second
  return asked == nullptr ? usual : std::strtoull(asked, nullptr, 10);
}

class InjectedFaults : public app::test::TemporaryFolder, public testing::WithParamInterface<const char*> {
 protected:
  InjectedFaults() {
    fs::create_directory(folder_ / "job");
    for (Job& job : test::jobs_in(folder_ / "job")) {
      if (job.name == GetParam()) job_ = std::move(job);
    }
  }

  ProgramRun run(const std::string& fault) {
    lasts_ = fault.ends_with("+");
    for (const fs::path& output : job_.outputs) std::ofstream(output) << old_contents;
    constexpr unsigned most_seconds = 40;
    return app::run_program(job_.arguments,
                            {.seconds = most_seconds,
                             .program = THRONG_FAULTY_PROGRAM,
                             .environment = {"THRONG_FAULT=" + fault, "THRONG_FAULT_COUNTS=" + counts_}});
  }

  /// Returns how often the job makes each kind of call, and keeps what it writes then.
  std::map<std::string, std::uint64_t> count_calls() {
    const ProgramRun whole = run("none");
    EXPECT_EQ(whole.exit_status, 0) << whole.errors;
    files_ = files();
    std::map<std::string, std::uint64_t> counts;
    std::ifstream lines(counts_);
    std::string kind;
    for (std::uint64_t count = 0; lines >> kind >> count;) counts[kind] = count;
    return counts;
  }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "job")) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
  }

  /// Expects that the run ended in words, and that each file is the old one or a whole new one.
  void expect_good_end(const ProgramRun& run) const {
    ASSERT_THAT(run.exit_status, testing::AnyOf(0, 1)) << run.errors;
    if (run.exit_status == 1) {
      EXPECT_THAT(run.errors, testing::StartsWith("throng: "));
      EXPECT_THAT(run.errors.substr(run.errors.rfind("throng: ")), testing::EndsWith("\n"));
    }
    remove_named_parts(run);
    EXPECT_EQ(files(), files_) << run.errors;
    for (const fs::path& output : job_.outputs) {
      const std::string contents = read(output);
      if (contents != old_contents) {
        EXPECT_TRUE(is_whole(output, contents)) << output << " has " << contents.size() << " bytes; " << run.errors;
      } else {
        EXPECT_EQ(run.exit_status, 1) << output << " was not written, and nothing was said: " << run.errors;
      }
    }
  }

  /// Removes the part that a recording leaves on purpose: it has all frames before the fault. The run says so, unless
  /// it has no memory to; then the next run does.
  void remove_named_parts(const ProgramRun& run) const {
    const bool has_no_memory = run.exit_status == 1 && run.errors.ends_with(
                                                           "the machine has no memory left; ask for "
                                                           "fewer agents or smaller models\n");
    for (const std::string& name : files()) {
      const fs::path part = folder_ / "job" / name;
      const bool named = run.errors.find("the frames before are in " + part.string() + "\n") != std::string::npos;
      if (named || (lasts_ && has_no_memory && part.extension() == ".part")) fs::remove(part);
    }
  }

  static bool is_whole(const fs::path& file, const std::string& contents) {
    if (file.extension() == ".rec") {
      return app::run_program({"--headless=none", "--replay", file.string()}).exit_status == 0;
    }
    if (file.extension() == ".pack") return app::run_program({"inspect", file.string()}).exit_status == 0;
    if (file.extension() == ".png") return contents.ends_with(std::string_view("IEND\xAE\x42\x60\x82"));
    return contents.ends_with("}\n") || contents.ends_with("}") || contents.ends_with("</svg>\n");
  }

  Job job_;
  bool lasts_ = false;  // all calls after the first that fails fail too
  std::vector<std::string> files_;
  const std::string counts_ = (folder_ / "counts").string();
};

TEST_P(InjectedFaults, EndInOneLineWithOldFilesWhole) {
  const std::uint64_t most = faults_of_a_kind(job_.name == "picture");
  std::uint64_t injected = 0;
  for (const auto& [kind, count] : count_calls()) {
    const std::uint64_t tried = std::min(count, most);
    for (std::uint64_t index = 0; index < tried; ++index) {
      const std::uint64_t number = 1 + (index * count + count / 2) / tried;
      for (const char* const lasting : {"", "+"}) {
        const std::string fault = kind + ":" + std::to_string(std::min(number, count)) + lasting;
        SCOPED_TRACE(job_.name + " with THRONG_FAULT=" + fault);
        expect_good_end(run(fault));
        ++injected;
      }
    }
  }
  std::printf("%llu faults in %s\n", static_cast<unsigned long long>(injected), job_.name.c_str());
  EXPECT_GT(injected, 0U);
}

// A suite each, so that ctest runs them side by side.
INSTANTIATE_TEST_SUITE_P(Run, InjectedFaults, testing::Values("run"));
INSTANTIATE_TEST_SUITE_P(Picture, InjectedFaults, testing::Values("picture"));
INSTANTIATE_TEST_SUITE_P(Compare, InjectedFaults, testing::Values("compare"));
INSTANTIATE_TEST_SUITE_P(Bake, InjectedFaults, testing::Values("bake"));
INSTANTIATE_TEST_SUITE_P(Inspect, InjectedFaults, testing::Values("inspect"));
INSTANTIATE_TEST_SUITE_P(Pose, InjectedFaults, testing::Values("pose"));
INSTANTIATE_TEST_SUITE_P(Lod, InjectedFaults, testing::Values("lod"));
INSTANTIATE_TEST_SUITE_P(Bench, InjectedFaults, testing::Values("bench"));

}  // namespace
}  // namespace throng::injected_faults_test
