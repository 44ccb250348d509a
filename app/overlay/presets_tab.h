#pragma once

#include <string>

#include "app/overlay/tabs.h"
#include "app/overlay/tuning_pair.h"

namespace throng::app {

/// Tunings to come back to: two that change places at a key, and files with names.
class PresetsTab {
 public:
  void show(const TabContext& context);

  /// A and B; key B changes their places.
  TuningPair pair;

 private:
  void show_pair(const TabContext& context);
  void show_saving(const TabContext& context);
  void show_names(const TabContext& context);

  std::string name_;
  std::string about_to_delete_;  ///< asked once; the second time it is done
};

}  // namespace throng::app
