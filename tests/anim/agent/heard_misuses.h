#pragma once

#include <string>
#include <vector>

#include "engine/anim/base/misuse.h"

namespace throng::anim {

/// Hears of the misuses that a test makes on purpose, as long as it lives. A build with assertions would end at them.
class HeardMisuses {
 public:
  HeardMisuses() {
    all().clear();
    before_ =
        set_misuse_hook([](const Misuse& misuse) { all().push_back(std::string(misuse.call) + ": " + misuse.reason); });
  }
  ~HeardMisuses() { set_misuse_hook(before_); }
  HeardMisuses(const HeardMisuses&) = delete;
  HeardMisuses& operator=(const HeardMisuses&) = delete;

  /// Returns "call: reason" of each, in their order.
  static std::vector<std::string>& all() {
    static std::vector<std::string> heard;
    return heard;
  }

 private:
  MisuseHook before_;
};

}  // namespace throng::anim
