#include "engine/base/files/child_process.h"

#if !defined(_WIN32)  // child_process_windows.cpp is for Windows

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace throng {
namespace {

/// A file without a name, which a child writes and we read.
class Capture {
 public:
  Capture() : descriptor_(memfd_create("throng-output", MFD_CLOEXEC)) {}
  ~Capture() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  int descriptor() const { return descriptor_; }
  std::string text() const {
    constexpr std::size_t most_bytes = std::size_t{1} << 20U;  // a program says what matters before
    std::string all;
    std::array<char, 4096> part{};
    lseek(descriptor_, 0, SEEK_SET);
    for (ssize_t count = 0; all.size() < most_bytes && (count = read(descriptor_, part.data(), part.size())) > 0;) {
      all.append(part.data(), static_cast<std::size_t>(count));
    }
    return all;
  }

 private:
  int descriptor_;
};

/// Runs in the child. The program's output goes into `output` and `errors`; `reason` is where the number of an error
/// goes if it cannot be started.
[[noreturn]] void become_program(char* const* words, const char* folder, unsigned seconds, int output, int errors,
                                 int reason) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  alarm(seconds);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGXFSZ, SIG_DFL);
  if (folder[0] == '\0' || chdir(folder) == 0) execvp(words[0], words);
  const int number = errno;
  [[maybe_unused]] const auto told = write(reason, &number, sizeof(number));
  _exit(127);
}

}  // namespace

int status_of(int child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::vector<char*> as_arguments(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

Result<EndedChild> run_child(const std::vector<std::string>& words, const ChildTreatment& treatment) {
  const auto failed = [&](int number) {
    return Error{words.front() + " cannot be run: " + std::generic_category().message(number)};
  };
  std::vector<std::string> copies = words;
  const std::vector<char*> pointers = as_arguments(copies);
  const Capture output, errors, reason;
  if (output.descriptor() < 0 || errors.descriptor() < 0 || reason.descriptor() < 0) return failed(errno);
  const pid_t child = fork();
  if (child < 0) return failed(errno);
  if (child == 0) {
    become_program(pointers.data(), treatment.folder.c_str(), treatment.seconds, output.descriptor(),
                   errors.descriptor(), reason.descriptor());
  }
  const int status = status_of(child);
  const std::string why = reason.text();
  int number = 0;
  if (why.size() == sizeof(number)) {
    std::memcpy(&number, why.data(), sizeof(number));
    return failed(number);
  }
  return EndedChild{.status = status, .output = output.text(), .errors = errors.text()};
}

std::string ask_in_child(const std::function<std::string()>& ask, unsigned seconds) {
  const Capture answer;
  if (answer.descriptor() < 0) return {};
  const pid_t child = fork();
  if (child < 0) return {};
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    alarm(seconds);
    std::string text;
    try {
      text = ask();
    } catch (...) {
      _exit(1);
    }
    _exit(write(answer.descriptor(), text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  return status_of(child) == 0 ? answer.text() : std::string();
}

Result<std::string> own_program() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return Error{"the system does not say which program this is: " + error.message()};
  return program.string();
}

}  // namespace throng

#endif  // !_WIN32
