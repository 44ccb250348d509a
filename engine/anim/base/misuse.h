#pragma once

#include <string>

#include "throng/host.h"

#include "engine/base/result.h"

namespace throng::anim {

/// Hears of the misuses of its thread while it lives, beside the hook and the listeners before it. Listeners of a
/// thread die in reverse order.
class MisuseListener {
 public:
  MisuseListener();
  ~MisuseListener();
  MisuseListener(const MisuseListener&) = delete;
  MisuseListener& operator=(const MisuseListener&) = delete;

  void hear(const Misuse& misuse);
  /// Returns the reason of the first misuse; an empty text if there was none.
  const std::string& reason() const { return reason_; }

 private:
  MisuseListener* before_;
  std::string reason_;
};

/// Tells the hook of a misuse. Returns false, as an ignored call does.
bool report_misuse(const Misuse& misuse);

/// Tells the hook of a misuse, and returns it as the error of the call.
Error refuse(const Misuse& misuse);

}  // namespace throng::anim
