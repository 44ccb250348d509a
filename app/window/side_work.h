#pragma once

#include <mutex>
#include <string>
#include <thread>

#include "app/character/load_options.h"
#include "engine/base/result.h"

namespace throng::app {

/// Does one piece of work on a thread of its own, so that a window goes on meanwhile. Without another thread it does
/// the work at once.
class SideWork {
 public:
  /// How far it is.
  struct Progress {
    double share = 0;  ///< that is done, 0 to 1
    std::string what;  ///< what comes now; empty: it has not said anything yet
  };

  explicit SideWork(LongWork work);
  /// Gives the work up, and waits for it.
  ~SideWork();
  SideWork(const SideWork&) = delete;
  SideWork& operator=(const SideWork&) = delete;

  /// Lets the work end at its next progress.
  void give_up();
  bool has_ended() const;
  Progress progress() const;
  /// Returns how it ended. Errors: it threw an exception, whose words they are. Call it once the work has ended.
  const Status& outcome() const { return outcome_; }

 private:
  struct GivenUp {};
  void run();
  void take(double share, const std::string& what);

  const LongWork work_;
  mutable std::mutex mutex_;
  Progress progress_;
  bool is_given_up_ = false, has_ended_ = false;
  Status outcome_ = Done{};
  std::thread thread_;  // last, as it uses all of it
};

}  // namespace throng::app
