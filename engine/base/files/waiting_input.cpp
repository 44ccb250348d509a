#include "engine/base/files/waiting_input.h"

#if !defined(_WIN32)  // waiting_input_windows.cpp is for Windows

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace throng {
namespace {

Error cannot_be_read() { return {"it cannot be read: " + std::generic_category().message(errno)}; }

}  // namespace

WaitingInput::~WaitingInput() {
  stop();
  if (ends_[0] >= 0) close(ends_[0]);
}

Status WaitingInput::open() {
  if (pipe2(ends_.data(), O_CLOEXEC) != 0) return cannot_be_read();
  return Done{};
}

Result<std::optional<std::size_t>> WaitingInput::read(std::span<char> bytes) {
  for (;;) {
    std::array<pollfd, 2> waits{pollfd{descriptor_, POLLIN, 0}, pollfd{ends_[0], POLLIN, 0}};
    if (poll(waits.data(), waits.size(), -1) < 0) {
      if (errno == EINTR) continue;
      return Error{"it cannot be waited for"};
    }
    if (waits[1].revents != 0) return std::optional<std::size_t>();
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count >= 0) return std::optional(static_cast<std::size_t>(count));
    if (errno != EINTR && errno != EAGAIN) return cannot_be_read();
  }
}

void WaitingInput::stop() {
  if (!is_stopped_.exchange(true) && ends_[1] >= 0) close(ends_[1]);
}

}  // namespace throng

#endif  // !_WIN32
