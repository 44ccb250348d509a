#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace throng::app {

/// Shows a bar on a terminal while something long begins: how far it is, and what it is at. Nothing is seen of what
/// takes less than half a second, and elsewhere nothing at all.
class StartLine {
 public:
  StartLine();
  /// Takes the line away.
  ~StartLine();
  StartLine(const StartLine&) = delete;
  StartLine& operator=(const StartLine&) = delete;

  /// Says what begins now. `share` of 0 to 1 is done. Nothing is shown while `what` is empty, for others to write. Any
  /// thread may call it.
  void tell(double share, std::string what);

 private:
  void show();

  std::mutex mutex_;
  std::condition_variable ended_;
  double share_ = 0;
  std::string what_;
  bool is_shown_ = false, has_ended_ = false;
  std::thread shows_;
};

/// Returns "[=======             ] Knight.glb, clip 26 of 76".
std::string bar_text(double share, const std::string& what);

}  // namespace throng::app
