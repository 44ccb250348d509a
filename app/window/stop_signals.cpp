#include "app/window/stop_signals.h"

#include <csignal>
#include <cstdlib>

#include "app/files/exit_status.h"
#include "engine/base/files/process.h"

namespace throng::app {
namespace {

volatile std::sig_atomic_t stop_signal = 0;

void take(int signal) {
  if (stop_signal != 0) std::_Exit(exit_of_signal(signal));
  stop_signal = signal;
}

}  // namespace

StopSignals::StopSignals() {
  stop_signal = 0;
  for (const int signal : ending_signals()) catch_signal(signal, take);
}

StopSignals::~StopSignals() {
  for (const int signal : ending_signals()) release_signal(signal, take);
}

int asked_to_stop() { return stop_signal; }

}  // namespace throng::app
