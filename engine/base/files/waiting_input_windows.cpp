#if defined(_WIN32)

#include <cerrno>
#include <string>
#include <system_error>

#include <io.h>
#include <windows.h>

#include "engine/base/files/waiting_input.h"

namespace throng {
namespace {

/// Returns whether a read would not wait: the system tells it of pipes alone, and of their ends by an error.
bool has_something(int descriptor) {
  DWORD available = 0;
  HANDLE const handle = reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
  return PeekNamedPipe(handle, nullptr, 0, nullptr, &available, nullptr) == 0 || available > 0;
}

}  // namespace

WaitingInput::~WaitingInput() = default;

Status WaitingInput::open() { return Done{}; }

Result<std::optional<std::size_t>> WaitingInput::read(std::span<char> bytes) {
  constexpr DWORD pause = 10;  // milliseconds
  for (; !is_stopped_; Sleep(pause)) {
    if (!has_something(descriptor_)) continue;
    const int count = _read(descriptor_, bytes.data(), static_cast<unsigned>(bytes.size()));
    if (count >= 0) return std::optional(static_cast<std::size_t>(count));
    return Error{"it cannot be read: " + std::generic_category().message(errno)};
  }
  return std::optional<std::size_t>();
}

void WaitingInput::stop() { is_stopped_ = true; }

}  // namespace throng

#endif  // _WIN32
