#include "engine/base/files/process.h"

#if !defined(_WIN32)  // process_windows.cpp is for Windows

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include <unistd.h>

namespace throng {

static_assert(standard_input == STDIN_FILENO && standard_output == STDOUT_FILENO && standard_error == STDERR_FILENO);

int process_id() { return getpid(); }

bool is_gone(int process) { return kill(process, 0) != 0 && errno == ESRCH; }

bool is_terminal(int descriptor) { return isatty(descriptor) == 1; }

bool may_write(const std::filesystem::path& place) { return access(place.c_str(), W_OK) == 0; }

void say_without_memory(std::string_view text) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

void set_variable(const char* name, const char* value) { setenv(name, value, 1); }

void clear_variable(const char* name) { unsetenv(name); }

void ignore_signals_of_writers() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

std::span<const int> ending_signals() {
  static constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};
  return signals;
}

void catch_signal(int signal, void (*handler)(int)) {
  struct sigaction before {};
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

void release_signal(int signal, void (*handler)(int)) {
  struct sigaction now {};
  sigaction(signal, nullptr, &now);
  if (now.sa_handler == handler) std::signal(signal, SIG_DFL);
}

}  // namespace throng

#endif  // !_WIN32
