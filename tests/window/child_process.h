#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace throng::app {

using Deadline = std::chrono::steady_clock::time_point;

/// Returns a deadline that is late enough for a loaded machine that draws in software. Every wait ends as soon as what
/// it waits for is there.
inline Deadline soon() { return std::chrono::steady_clock::now() + std::chrono::seconds(25); }

/// A program that runs beside the test and is ended with it. Its standard output is read line by line.
class ChildProcess {
 public:
  /// Starts a program. `environment` has elements "NAME=value", which are added to the test's own or replace those of
  /// the same name. The program works in `folder`, or in the test's own if that is empty.
  ChildProcess(const std::vector<std::string>& command, const std::vector<std::string>& environment,
               const std::string& folder = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] bool started() const { return process_ > 0; }
  /// Returns its number in the system.
  [[nodiscard]] pid_t process() const { return process_; }

  /// Returns its next whole line; nothing if it has ended or the deadline is past.
  std::optional<std::string> read_line(Deadline deadline);

  /// Waits for its end, and returns its exit status. Returns nothing if it still runs at the deadline, and -1 if a
  /// signal ended it.
  std::optional<int> exit_status(Deadline deadline);

 private:
  pid_t process_ = -1;
  int output_ = -1;
  std::string unread_;
  std::optional<int> status_;
};

}  // namespace throng::app
