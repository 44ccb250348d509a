// A program that runs beside this one is looked at without a wait, and asked to end.
#include "engine/base/files/piped_program.h"

#include <algorithm>
#include <span>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace throng::piped_program_test {
namespace {

Result<PipedProgram> started(const char* script) { return PipedProgram::start({"sh", "-c", script}); }

/// Looks again and again until the program has ended, and returns how.
int end_of(PipedProgram& program) {
  while (true) {
    if (const auto status = program.look()) return *status;
    std::this_thread::yield();
  }
}

TEST(PipedProgram, IsLookedAtWhileItRuns) {
  auto program = started("echo begun; read line; echo $line; exit 3");
  ASSERT_TRUE(program);
  while (program->answer() != "begun\n") ASSERT_FALSE(program->look()) << "it waits for a line";
  const std::string line = "on\n";
  program->write(std::as_bytes(std::span(line)));
  EXPECT_EQ(end_of(*program), 3);
  EXPECT_EQ(program->answer(), "begun\non\n");
}

TEST(PipedProgram, EndsAsItWantsWhenItIsAsked) {
  auto program = started("trap 'echo all written; exit 7' TERM; echo begun; while :; do sleep 0.01; done");
  ASSERT_TRUE(program);
  while (program->answer() != "begun\n") ASSERT_FALSE(program->look());
  program->ask_to_end();
  EXPECT_EQ(end_of(*program), 7);
  EXPECT_EQ(program->answer(), "begun\nall written\n");
}

TEST(PipedProgram, GivesWayToOthers) {
  auto program = started("read line; nice");
  ASSERT_TRUE(program);
  program->give_way();
  const std::string line = "on\n";
  program->write(std::as_bytes(std::span(line)));
  EXPECT_EQ(end_of(*program), 0);
  EXPECT_EQ(program->answer(), std::to_string(std::min(getpriority(PRIO_PROCESS, 0) + 10, 19)) + "\n");
}

}  // namespace
}  // namespace throng::piped_program_test
