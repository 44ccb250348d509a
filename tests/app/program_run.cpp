#include "tests/app/program_run.h"

#include <array>
#include <csignal>
#include <filesystem>
#include <string_view>

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace throng::app {
namespace {

/// A file without a name that a child writes and we read back.
class Capture {
 public:
  Capture() : descriptor_(memfd_create("capture", MFD_CLOEXEC)) {}
  ~Capture() { close(descriptor_); }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  int descriptor() const { return descriptor_; }

  std::string text() const {
    std::string all;
    std::array<char, 4096> part{};
    lseek(descriptor_, 0, SEEK_SET);
    for (ssize_t count = 0; (count = read(descriptor_, part.data(), part.size())) > 0;) {
      all.append(part.data(), static_cast<std::size_t>(count));
    }
    return all;
  }

 private:
  int descriptor_;
};

std::vector<char*> environment_without_display(std::vector<std::string>& more) {
  std::vector<char*> variables;
  for (std::string& variable : more) variables.push_back(variable.data());
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (!text.starts_with("DISPLAY=") && !text.starts_with("WAYLAND_DISPLAY=")) variables.push_back(*variable);
  }
  variables.push_back(nullptr);
  return variables;
}

int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Becomes the program. It runs in the child, which shares nothing with a thread of ours.
[[noreturn]] void become_program(const std::vector<char*>& arguments, const std::vector<char*>& environment, int output,
                                 int errors, const ProgramTreatment& treatment) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (!treatment.input.empty()) dup2(open(treatment.input.c_str(), O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  if (treatment.address_space != 0) {
    const rlimit limit{treatment.address_space, treatment.address_space};
    setrlimit(RLIMIT_AS, &limit);
  }
  if (!treatment.cores.empty()) {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    for (const std::size_t core : treatment.cores) CPU_SET(core, &allowed);
    sched_setaffinity(0, sizeof(allowed), &allowed);
  }
  // A shell lets what runs in the background ignore some, and the program keeps to that.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  if (treatment.seconds != 0) alarm(treatment.seconds);
  const bool is_there = treatment.folder.empty() || chdir(treatment.folder.c_str()) == 0;
  if (is_there) execve(arguments.front(), arguments.data(), environment.data());
  dprintf(STDERR_FILENO, "%s cannot be run\n", arguments.front());
  _exit(127);
}

}  // namespace

bool has_ended(pid_t child) {
  siginfo_t ended{};
  waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
  return ended.si_pid == child;
}

std::function<void(pid_t)> send(int signal, const std::string& once_written) {
  return [=](pid_t child) {
    std::string file = once_written;
    if (const std::size_t at = file.find("PID"); at != std::string::npos) file.replace(at, 3, std::to_string(child));
    std::error_code error;
    const auto has_bytes = [&] { return std::filesystem::file_size(file, error) > 0 && !error; };
    while (!file.empty() && !has_bytes() && !has_ended(child)) usleep(1000);
    kill(child, signal);
  };
}

ProgramRun run_program(const std::vector<std::string>& arguments, const ProgramTreatment& treatment) {
  std::vector<std::string> words{treatment.program.empty() ? THRONG_PROGRAM : treatment.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::vector<std::string> more = treatment.environment;
  const std::vector<char*> environment = environment_without_display(more);
  const Capture output;
  const Capture errors;
  const int other = treatment.output.empty() ? -1 : open(treatment.output.c_str(), O_WRONLY | O_CLOEXEC);
  const pid_t child = fork();
  if (child == 0) {
    become_program(pointers, environment, other >= 0 ? other : output.descriptor(), errors.descriptor(), treatment);
  }
  if (other >= 0) close(other);
  if (treatment.meanwhile) treatment.meanwhile(child);
  const int exit_status = wait_for(child);
  return {exit_status, output.text(), errors.text()};
}

}  // namespace throng::app
