#pragma once

#include "app/overlay/sweep_view.h"
#include "app/overlay/tabs.h"
#include "app/overlay/timeline_view.h"

namespace throng::app {

/// How work is cut and shared out, and what came of it.
class SchedulingTab {
 public:
  void show(const TabContext& context);

 private:
  void show_timeline(const TabContext& context);

  SweepView sweep_;
  TimelineView timeline_;
};

}  // namespace throng::app
