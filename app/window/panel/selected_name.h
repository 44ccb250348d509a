#pragma once

#include <string>

#include "app/show/report/selection_report.h"
#include "engine/base/text/joined.h"

namespace throng::app {

/// Returns "agent 1,234", or "person 74" of a recorded crowd, by the name that its file has.
inline std::string name_of(const SelectionReport& selected) {
  return selected.tracked != nullptr ? "person " + selected.tracked->id : "agent " + with_thousands(selected.agent);
}

}  // namespace throng::app
