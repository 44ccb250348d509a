#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace throng::app {

using Deadline = std::chrono::steady_clock::time_point;

/// Long enough for a loaded machine that draws in software; every wait ends as soon as what it waits for is there.
inline Deadline soon() { return std::chrono::steady_clock::now() + std::chrono::seconds(25); }

/// A program that runs beside the test and is ended with it. Its standard output is read line by line.
class ChildProcess {
 public:
  /// `environment`: "NAME=value", added to the test's own or in place of what has the same name. `folder`: what it
  /// works in; empty: the test's own.
  ChildProcess(const std::vector<std::string>& command, const std::vector<std::string>& environment,
               const std::string& folder = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] bool started() const { return process_ > 0; }

  /// Its next whole line; nothing once it has ended or the deadline is past.
  std::optional<std::string> read_line(Deadline deadline);

  /// Waits for its end. Nothing when it still runs at the deadline; -1 when a signal ended it.
  std::optional<int> exit_status(Deadline deadline);

 private:
  pid_t process_ = -1;
  int output_ = -1;
  std::string unread_;
  std::optional<int> status_;
};

}  // namespace throng::app
