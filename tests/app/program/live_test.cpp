// Rows of standard input, as the real program takes them.
#include <csignal>
#include <string>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/program_run.h"
#include "tests/tracks/track_file.h"

namespace throng::app::live_program_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class LiveProgram : public testing::Test {
 protected:
  ProgramRun run(const std::string& text) const {
    return run_program({"--headless=none", "--trajectories", "-"}, {.input = folder_.file("rows", text)});
  }
  const TrackFolder folder_;
};

TEST_F(LiveProgram, EndsWithItsInput) {
  const ProgramRun run = this->run("id,time,x,y\n1,0,0,0\n1,1,1,0\n1,2,2,0\n");
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_THAT(run.errors, HasSubstr("-: table with a header, rows as they come."));
}

TEST_F(LiveProgram, RefusesWhatAFileOfItWouldBeRefusedFor) {
  const ProgramRun wrong = run("id,time,x,y\n1,0,0,0\n1,1,here,0\n");
  EXPECT_EQ(wrong.exit_status, 1);
  EXPECT_THAT(wrong.errors, HasSubstr("throng: -: line 3: \"here\" is not a number"));
  EXPECT_EQ(run("").exit_status, 1);
  const ProgramRun database = run(std::string("SQLite format 3\0.....", 21));
  EXPECT_EQ(database.exit_status, 1);
  EXPECT_THAT(database.errors, HasSubstr("give its file's name instead of -"));
}

// The other end of the pipe stays open.
TEST_F(LiveProgram, EndsWhenItIsAskedToWhileItWaits) {
  const std::string pipe = folder_.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int end = open(pipe.c_str(), O_RDWR | O_CLOEXEC);
  const ProgramTreatment treatment{.input = pipe, .meanwhile = [](pid_t child) {
                                     usleep(300'000);
                                     kill(child, SIGINT);
                                   }};
  const ProgramRun before = run_program({"--headless=none", "--trajectories", "-"}, treatment);
  EXPECT_EQ(before.exit_status, 130) << before.errors;
  const std::string rows = "id,time,x,y\n1,0,0,0\n1,1,1,0\n";
  ASSERT_EQ(write(end, rows.data(), rows.size()), static_cast<ssize_t>(rows.size()));
  const ProgramRun after = run_program({"--headless=none", "--trajectories", "-"}, treatment);
  EXPECT_EQ(after.exit_status, 130) << after.errors;
  close(end);
}

}  // namespace
}  // namespace throng::app::live_program_test
