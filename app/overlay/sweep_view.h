#pragma once

#include "app/overlay/tabs.h"

namespace throng::app {

/// A sweep over the crowd that runs: what to vary, a button, and the curve that comes of it. A click on a stop of the
/// curve takes that value.
class SweepView {
 public:
  void show(const TabContext& context);

 private:
  void show_button(const TabContext& context) const;

  SweptValue value_ = SweptValue::tile;
};

}  // namespace throng::app
