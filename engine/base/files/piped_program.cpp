#include "engine/base/files/piped_program.h"

#if !defined(_WIN32)  // child_process_windows.cpp is for Windows

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/base/files/child_process.h"

extern char** environ;

namespace throng {
namespace {

constexpr std::size_t most_answer = std::size_t{1} << 20U;

/// Both ends of a pipe, which close with it. No program that is started gets them by chance.
struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() = default;
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) close(end);
    }
  }
  bool make() { return pipe2(ends.data(), O_CLOEXEC) == 0; }
  int take(std::size_t end) { return std::exchange(ends.at(end), -1); }
};

void close_end(int& end) {
  if (end >= 0) close(std::exchange(end, -1));
}

/// Says how a program is started: in a group of its own, with the signals that it would have from a shell.
class SpawnRules {
 public:
  SpawnRules(int reads, int says) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, reads, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, says, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, says, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes_, &usual);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  }
  SpawnRules(const SpawnRules&) = delete;
  SpawnRules& operator=(const SpawnRules&) = delete;
  ~SpawnRules() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&actions_);
  }

  int start(pid_t& process, std::vector<std::string> words) const {
    std::vector<char*> pointers = as_arguments(words);
    return posix_spawnp(&process, pointers.front(), &actions_, &attributes_, pointers.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

Result<PipedProgram> PipedProgram::start(const std::vector<std::string>& words) {
  Pipe input, output;
  const auto refused = [](int error) {
    return Error{error == ENOENT ? "there is none in PATH" : std::generic_category().message(error)};
  };
  if (!input.make() || !output.make()) return refused(errno);
  PipedProgram child;
  const int error = SpawnRules(input.ends[0], output.ends[1]).start(child.process_, words);
  if (error != 0) return child.process_ = -1, refused(error);
  child.input_ = input.take(1);
  child.output_ = output.take(0);
  for (const int end : {child.input_, child.output_}) fcntl(end, F_SETFL, fcntl(end, F_GETFL) | O_NONBLOCK);
  return child;
}

PipedProgram::PipedProgram(PipedProgram&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      input_(std::exchange(other.input_, -1)),
      output_(std::exchange(other.output_, -1)),
      answer_(std::move(other.answer_)) {}

PipedProgram::~PipedProgram() {
  close_end(input_);
  close_end(output_);
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

// Reads the program's output meanwhile: a program stops when its output is not read.
bool PipedProgram::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    std::array<pollfd, 2> ends{
        {{.fd = input_, .events = POLLOUT, .revents = 0}, {.fd = output_, .events = POLLIN, .revents = 0}}};
    if (poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) return false;
    if (ends[1].revents != 0) listen();
    if (ends[0].revents == 0) continue;
    const ssize_t count = ::write(input_, bytes.data(), bytes.size());
    if (count < 0 && errno != EAGAIN && errno != EINTR) return false;
    if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

void PipedProgram::listen() {
  std::array<char, 4096> buffer;
  while (output_ >= 0) {
    const ssize_t count = read(output_, buffer.data(), buffer.size());
    if (count < 0) return;
    if (count == 0) return close_end(output_);
    answer_.append(buffer.data(), static_cast<std::size_t>(count));
    if (answer_.size() > most_answer) answer_.erase(0, answer_.size() - most_answer);
  }
}

std::optional<int> PipedProgram::look() {
  listen();
  siginfo_t state{};
  const int failed = waitid(P_PID, static_cast<id_t>(process_), &state, WEXITED | WNOHANG | WNOWAIT);
  if (failed == 0 && state.si_pid == 0) return std::nullopt;
  return finish();
}

void PipedProgram::ask_to_end() const { kill(process_, SIGTERM); }

void PipedProgram::give_way() const {
  constexpr int politely = 10;
  const auto process = static_cast<id_t>(process_);
  setpriority(PRIO_PROCESS, process, getpriority(PRIO_PROCESS, process) + politely);
}

int PipedProgram::finish() {
  close_end(input_);
  while (output_ >= 0) {
    pollfd end{.fd = output_, .events = POLLIN, .revents = 0};
    if (poll(&end, 1, -1) < 0 && errno != EINTR) break;
    listen();
  }
  return status_of(std::exchange(process_, -1));
}

}  // namespace throng

#endif  // !_WIN32
