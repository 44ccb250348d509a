#pragma once

#include <cstddef>

#include "app/overlay/tabs.h"

namespace throng::app {

/// Everything about the selected agent: what level of detail gave it, what it met, each entity's block; and hands on
/// it: hold its clip at a time, push it.
class AgentTab {
 public:
  void show(const TabContext& context);

 private:
  void show_blocks(const TabContext& context, const SelectionReport& selected);

  std::size_t entity_ = SIZE_MAX;  ///< whose block is shown; past the end: the last's
};

}  // namespace throng::app
