// throng check refuses cases before it draws anything, and pictures that git could not bring back.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/check/git.h"
#include "app/files/program_words.h"
#include "engine/base/files/child_process.h"
#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::check_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CheckRefusal : public test::TemporaryFolder {
 protected:
  std::string write_cases(const std::string& text) const {
    std::ofstream(folder_ / "cases.json") << text;
    return folder_ / "cases.json";
  }
  ProgramRun check(std::vector<std::string> more) const {
    more.insert(more.begin(), {"check", folder_ / "cases.json", "--out", folder_ / "out"});
    return run_program(more);
  }
  void expect_usage(const ProgramRun& run, const std::string& line) const {
    EXPECT_EQ(run.exit_status, 2);
    EXPECT_EQ(run.errors, "throng: " + line + "\n");
    EXPECT_EQ(run.output, "");
  }
};

TEST_F(CheckRefusal, OfAFileThatIsNotThere) {
  expect_usage(check({}), (folder_ / "cases.json").string() + ": there is no such file; check the path");
}

TEST_F(CheckRefusal, OfBadJsonNamesFilePlaceAndRemedy) {
  const std::string file = write_cases("{\"cases\": [}");
  expect_usage(check({}), file + ": is not JSON at line 1, column 12; mend it there");
  write_cases(R"({"cases": [{"name": "a", "sizes": "8x8"}]})");
  expect_usage(check({}), file + ": case 1 \"a\": unknown key \"sizes\"; is \"size\" meant?");
}

TEST_F(CheckRefusal, OfACaseThatItDoesNotHave) {
  const std::string file = write_cases(R"({"cases": [{"name": "plaza"}, {"name": "grid"}]})");
  expect_usage(check({"--case", "plasa"}), "--case plasa: " + file + " has no such case; near to it are plaza, grid");
}

TEST_F(CheckRefusal, OfForceWithoutUpdate) {
  write_cases(R"({"cases": [{"name": "plaza"}]})");
  expect_usage(check({"--force"}), "--force: goes with --update");
}

// A run of the program that fails, such as for a model that is not there, is a case that fails with its line.
TEST_F(CheckRefusal, OfTheProgramIsTheLineOfItsCase) {
  write_cases(R"({"cases": [{"name": "a", "models": "nobody.glb"}, {"name": "b", "options": ["--agent", "3"]}]})");
  const ProgramRun run = check({"--context", "egl"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_THAT(run.output, HasSubstr("NOT DRAWN a (egl): nobody.glb: there is no such file; check the path\n"));
  EXPECT_THAT(run.output, HasSubstr("NOT DRAWN b (egl): --agent: unknown option; is --agents meant?"));
  EXPECT_THAT(run.errors, HasSubstr("throng: 2 pictures: 0 as expected, 2 not drawn; see "));
}

TEST_F(CheckRefusal, OfAFullDiskIsSaid) {
  write_cases(R"({"cases": [{"name": "a", "models": "nobody.glb"}]})");
  fs::create_symlink("/dev/full", folder_ / "full.xml");
  const ProgramRun run = check({"--junit", folder_ / "full.xml"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_THAT(run.errors, HasSubstr("full.xml: "));
  EXPECT_THAT(run.errors, HasSubstr("No space left on device"));
}

class KeptByGit : public test::TemporaryFolder {
 protected:
  void SetUp() override {
    file_ = folder_ / "a.png";
    std::ofstream(file_) << "old";
    setenv("GIT_CEILING_DIRECTORIES", folder_.parent_path().c_str(), 1);
  }
  void TearDown() override {
    unsetenv("GIT_CEILING_DIRECTORIES");
    if (!path_.empty()) setenv("PATH", path_.c_str(), 1);
  }
  /// Returns whether git is installed and did it.
  bool git(std::vector<std::string> words) const {
    words.insert(words.begin(), {"git", "-C", folder_.string(), "-c", "user.name=a", "-c", "user.email=a@b"});
    const auto ended = run_child(words);
    return ended && ended->status == 0;
  }
  /// Puts a program in the place of git, which says a line and ends with a status.
  void fake_git(const std::string& line, int status) {
    path_ = std::getenv("PATH");
    fs::create_directory(folder_ / "bin");
    std::ofstream(folder_ / "bin" / "git") << "#!/bin/sh\necho '" << line << "'\nexit " << status << "\n";
    fs::permissions(folder_ / "bin" / "git", fs::perms::owner_all);
    setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }

  fs::path file_;
  std::string path_;
};

TEST_F(KeptByGit, FilesAreSafeOnceTheyAreCommitted) {
  if (!git({"init", "-q"})) {
    fake_git("", 0);
    EXPECT_EQ(missing_in_git({file_}), std::nullopt);
    return;
  }
  EXPECT_THAT(missing_in_git({file_}).value_or(""), HasSubstr("has uncommitted changes: a.png; commit them first"));
  ASSERT_TRUE(git({"add", "a.png"}));
  ASSERT_TRUE(git({"commit", "-q", "-m", "a"}));
  EXPECT_EQ(missing_in_git({file_}), std::nullopt);
  EXPECT_EQ(missing_in_git({file_, folder_ / "absent.png"}), std::nullopt);
  std::ofstream(folder_ / "other.txt") << "what is not replaced";
  EXPECT_EQ(missing_in_git({file_}), std::nullopt);
  std::ofstream(file_) << "new";
  EXPECT_THAT(missing_in_git({file_}).value_or(""), HasSubstr("has uncommitted changes: a.png"));
}

TEST_F(KeptByGit, IgnoredFilesAreNot) {
  if (!git({"init", "-q"})) fake_git("!! a.png", 0);
  std::ofstream(folder_ / ".gitignore") << "*.png\n";
  EXPECT_THAT(missing_in_git({file_}).value_or(""), HasSubstr("has uncommitted changes: a.png"));
}

TEST_F(KeptByGit, FilesOutsideOfItAreNot) {
  fake_git("", 128);
  EXPECT_THAT(missing_in_git({file_}).value_or(""), HasSubstr("git cannot bring back what is replaced in "));
  EXPECT_EQ(missing_in_git({folder_ / "absent.png"}), std::nullopt) << "nothing is lost";
}

TEST_F(KeptByGit, NothingIsWithoutIt) {
  path_ = std::getenv("PATH");
  setenv("PATH", folder_.c_str(), 1);
  EXPECT_THAT(missing_in_git({file_}).value_or(""), HasSubstr("git is not installed"));
}

TEST(ChildProcess, IsRunWithoutAShell) {
  const auto ended = run_child({"printf", "%s", "$HOME; `id`"});
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->output, "$HOME; `id`");
}

TEST(ChildProcess, ThatCannotBeStartedSaysWhy) {
  const auto ended = run_child({"no-such-program-anywhere"});
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().message, "no-such-program-anywhere cannot be run: No such file or directory");
}

TEST(ChildProcess, ThatNeverEndsIsEnded) { EXPECT_EQ(run_child({"sleep", "60"}, {.seconds = 1})->status, 128 + 14); }

TEST(ChildProcess, WordsAreAsAPersonTypesThem) {
  EXPECT_EQ(as_typed({"throng", "a b.glb", "it's", "--size=8x8", ""}), R"(throng 'a b.glb' 'it'\''s' --size=8x8 '')");
}

TEST(AskedInAChild, ACrashIsNoAnswer) {
  EXPECT_EQ(ask_in_child([] { return std::string("yes"); }, 5), "yes");
  EXPECT_EQ(ask_in_child([]() -> std::string { std::_Exit(3); }, 5), "");
}

}  // namespace
}  // namespace throng::app::check_test
