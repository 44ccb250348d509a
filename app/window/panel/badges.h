#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include "app/window/panel/tabs.h"

namespace throng::app {

/// A state that changes what is seen or kept, shown as long as it lasts.
struct Badge {
  const char* name;  ///< in the map of widgets, after "badge:"
  ImU32 dot;
  std::string words;
  std::string help;
  void (*end)(const TabContext& context) = nullptr;  ///< ends the state; null: a click cannot
};

/// Returns the badges of all states that last.
std::vector<Badge> badges_of(const TabContext& context);

}  // namespace throng::app
