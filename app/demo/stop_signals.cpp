#include "app/demo/stop_signals.h"

#include <array>
#include <csignal>

#include <unistd.h>

#include "app/files/exit_status.h"

namespace throng::app {
namespace {

constexpr std::array caught = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t stop_signal = 0;

void take(int signal) {
  if (stop_signal != 0) _exit(exit_of_signal(signal));
  stop_signal = signal;
}

}  // namespace

StopSignals::StopSignals() {
  stop_signal = 0;
  for (const int signal : caught) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = take;
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (const int signal : caught) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler == take) std::signal(signal, SIG_DFL);
  }
}

int asked_to_stop() { return stop_signal; }

}  // namespace throng::app
