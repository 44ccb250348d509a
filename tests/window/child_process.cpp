#include "tests/window/child_process.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace throng::app {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

std::string name_of(const std::string& variable) { return variable.substr(0, variable.find('=') + 1); }

std::vector<std::string> environment_with(const std::vector<std::string>& extra) {
  std::vector<std::string> all = extra;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string name = name_of(*variable);
    if (std::ranges::find(extra, name, name_of) == extra.end()) all.emplace_back(*variable);
  }
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  all.reserve(texts.size() + 1);
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

int milliseconds_until(Deadline deadline) {
  const auto left = std::chrono::duration_cast<milliseconds>(deadline - steady_clock::now()).count();
  return static_cast<int>(std::clamp<long>(left, 0, 60'000));
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::vector<std::string>& environment,
                           const std::string& folder) {
  std::array<int, 2> ends = {-1, -1};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
  output_ = ends[0];
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::vector<std::string> arguments = command, variables = environment_with(environment);
  if (posix_spawnp(&process_, command.front().c_str(), &actions, nullptr, pointers(arguments).data(),
                   pointers(variables).data()) != 0) {
    process_ = -1;
  }
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
}

ChildProcess::~ChildProcess() {
  if (process_ > 0 && !status_) {
    kill(process_, SIGTERM);
    if (!exit_status(steady_clock::now() + std::chrono::seconds(5))) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
  }
  if (output_ >= 0) close(output_);
}

std::optional<std::string> ChildProcess::read_line(Deadline deadline) {
  while (true) {
    if (const std::size_t end = unread_.find('\n'); end != std::string::npos) {
      std::string line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      return line;
    }
    pollfd waiting = {.fd = output_, .events = POLLIN, .revents = 0};
    if (poll(&waiting, 1, milliseconds_until(deadline)) <= 0) return std::nullopt;
    std::array<char, 4096> bytes = {};
    const ssize_t count = read(output_, bytes.data(), bytes.size());
    if (count <= 0) return std::nullopt;
    unread_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

std::optional<int> ChildProcess::exit_status(Deadline deadline) {
  while (!status_) {
    int how = 0;
    if (waitpid(process_, &how, WNOHANG) == process_) {
      status_ = WIFEXITED(how) ? WEXITSTATUS(how) : -1;
    } else if (steady_clock::now() >= deadline) {
      return std::nullopt;
    } else {
      std::this_thread::sleep_for(milliseconds(10));
    }
  }
  return status_;
}

}  // namespace throng::app
