#pragma once

#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace throng::app {

/// A terminal in the place of standard error.
class Terminal {
 public:
  Terminal() : terminal_(posix_openpt(O_RDWR | O_NOCTTY)), before_(dup(STDERR_FILENO)) {
    if (terminal_ < 0 || grantpt(terminal_) != 0 || unlockpt(terminal_) != 0) return;
    program_ = open(ptsname(terminal_), O_RDWR | O_NOCTTY);
    if (program_ >= 0) dup2(program_, STDERR_FILENO);
  }
  ~Terminal() {
    dup2(before_, STDERR_FILENO);
    for (const int file : {before_, program_, terminal_}) {
      if (file >= 0) close(file);
    }
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  bool is_there() const { return program_ >= 0; }

  /// Reads what comes until `text` is part of it. Returns all of it; without `text` if that does not come.
  std::string read_until(const std::string& text) const {
    constexpr int long_enough_ms = 20'000;
    std::string all;
    pollfd waits{.fd = terminal_, .events = POLLIN, .revents = 0};
    while (all.find(text) == std::string::npos && poll(&waits, 1, long_enough_ms) == 1) {
      char some[256];
      const ssize_t count = read(terminal_, some, sizeof(some));
      if (count <= 0) break;
      all.append(some, static_cast<std::size_t>(count));
    }
    return all;
  }

 private:
  int terminal_, before_, program_ = -1;
};

}  // namespace throng::app
