#pragma once

namespace throng::app {

/// As long as it lives, SIGINT, SIGTERM and SIGHUP ask the run to end after its frame, so that the run writes all it
/// has. A second signal ends the program at once. A signal that was ignored before stays ignored (nohup).
/// Only one may live at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
};

/// Returns the signal that asked the run to end; 0 as long as none did.
int asked_to_stop();

}  // namespace throng::app
