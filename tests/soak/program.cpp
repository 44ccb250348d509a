#include "tests/soak/program.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace throng::soak {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Becomes the program; the child shares nothing with a thread of ours. It ends with us.
[[noreturn]] void become_program(char* const* arguments, const char* folder, int output, int errors) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_DFL);  // a shell lets what runs in the background ignore it, and the program keeps to that
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  if (chdir(folder) == 0) execv(THRONG_PROGRAM, arguments);
  _exit(127);
}

/// Waits for the end of a child, or for that time. Returns whether it has ended.
bool has_ended(pid_t child, int& how, std::chrono::milliseconds longest) {
  for (const auto end = Clock::now() + longest; waitpid(child, &how, WNOHANG) != child;) {
    if (Clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

void watch(pid_t child, const ProgramTime& time, ProgramRun& run) {
  const auto begin = Clock::now();
  int how = 0;
  bool interrupted = time.until_interrupt <= 0;
  while (!has_ended(child, how, std::chrono::milliseconds(100))) {
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    run.figures.push_back(figures_of(child));
    if (!interrupted && run.figures.back().computed > time.until_interrupt) {
      interrupted = true;
      kill(child, SIGINT);
    }
    if (!run.hung && seconds > time.until_killed) {
      run.hung = true;
      kill(child, SIGKILL);
    }
  }
  run.status = WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& words, const fs::path& folder, const ProgramTime& time) {
  std::vector<std::string> all{THRONG_PROGRAM};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : all) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const fs::path said = folder / "said.txt", complained = folder / "complained.txt";
  const int output = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const int errors = open(complained.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const pid_t child = fork();
  if (child == 0) become_program(pointers.data(), folder.c_str(), output, errors);
  close(output);
  close(errors);
  ProgramRun run;
  watch(child, time, run);
  run.output = contents(said);
  run.errors = contents(complained);
  return run;
}

std::string as_command(const std::vector<std::string>& words) {
  std::string command = "throng";
  for (const std::string& word : words) {
    const bool plain = word.find_first_of(" *#'\"()$") == std::string::npos;
    command += plain ? " " + word : " '" + word + "'";
  }
  return command;
}

}  // namespace throng::soak
