#if defined(_WIN32)

#include <array>
#include <csignal>
#include <cstdlib>

#include <io.h>
#include <windows.h>

#include "engine/base/files/process.h"

namespace throng {

int process_id() { return static_cast<int>(GetCurrentProcessId()); }

bool is_gone(int process) {
  HANDLE const opened = OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process));
  if (opened == nullptr) return GetLastError() == ERROR_INVALID_PARAMETER;
  const bool has_ended = WaitForSingleObject(opened, 0) == WAIT_OBJECT_0;
  CloseHandle(opened);
  return has_ended;
}

bool is_terminal(int descriptor) { return _isatty(descriptor) != 0; }

bool may_write(const std::filesystem::path& place) {
  constexpr int to_write = 2;
  return _waccess(place.c_str(), to_write) == 0;
}

void say_without_memory(std::string_view text) {
  [[maybe_unused]] const int written = _write(standard_error, text.data(), static_cast<unsigned>(text.size()));
}

void set_variable(const char* name, const char* value) { _putenv_s(name, value); }

void clear_variable(const char* name) { _putenv_s(name, ""); }

void ignore_signals_of_writers() {}  // writers have errors alone there

std::span<const int> ending_signals() {
  static constexpr std::array signals = {SIGINT, SIGTERM, SIGBREAK};
  return signals;
}

// The system takes the handler away before it calls it: a second signal ends the program.
void catch_signal(int signal, void (*handler)(int)) {
  if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void release_signal(int signal, void (*handler)(int)) {
  const auto now = std::signal(signal, SIG_DFL);
  if (now != handler && now != SIG_ERR) std::signal(signal, now);
}

}  // namespace throng

#endif  // _WIN32
