#pragma once

#include "throng/host.h"

namespace throng::anim {

/// Returns the functions that hear of zones. They are null while no host has set them.
const ZoneHooks& zone_hooks();

/// Tells the host of a zone of this thread while it lives.
class Zone {
 public:
  Zone(const char* name, int pu) : hooks_(zone_hooks()), pu_(pu) {
    if (hooks_.begin != nullptr) hooks_.begin(name, pu, hooks_.context);
  }
  ~Zone() {
    if (hooks_.end != nullptr) hooks_.end(pu_, hooks_.context);
  }
  Zone(const Zone&) = delete;
  Zone& operator=(const Zone&) = delete;

 private:
  ZoneHooks hooks_;  // a copy: what began a zone ends it
  int pu_;
};

}  // namespace throng::anim
