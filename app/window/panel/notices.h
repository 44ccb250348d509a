#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "app/window/panel/controls/widgets.h"

namespace throng::app {

struct TabContext;

/// The warnings and messages that the person closed, and the warnings that came with many others.
struct NoticeMemory {
  std::set<std::string> warnings;
  std::set<std::uint64_t> messages;
  std::set<std::string> alone, together;  ///< the open warnings, by how they came
  bool lists_together = false;
};

/// Shows over the crowd, from its top down, what a person has to know:
///   - a badge for each state that changes what is seen or kept, such as a recording, as long as it lasts. A click ends
///     the state, where a click can;
///   - warnings, which stay until they are closed. Many that come at once, as of a folder of models, share one line,
///     which a click lists;
///   - messages, which fade.
/// Returns the y below the last of them.
float show_notices(const TabContext& context, const Area& crowd);

}  // namespace throng::app
