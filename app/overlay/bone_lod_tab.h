#pragma once

#include "app/overlay/bone_list.h"
#include "app/overlay/tabs.h"

namespace throng::app {

/// From where on how many bones are kept, and the list of them.
class BoneLodTab {
 public:
  void show(const TabContext& context);

 private:
  BoneList list_;
};

}  // namespace throng::app
