#pragma once

#include <optional>
#include <string>

#include "engine/base/json/json.h"
#include "engine/tracks/file_plan.h"

namespace throng {

/// Holds the plan and the step of a scenario of Vadere.
struct VadereScenario {
  FilePlan plan;
  double seconds_a_step = 0.4;  ///< of simulation
};

/// Reads the topography of a scenario: obstacles, the border as a floor, targets as exits, areas of measurement as
/// lines. The error is the end of a sentence.
Result<VadereScenario> vadere_scenario(const Json& json);

/// Returns the scenario of a file of Vadere: the scenario with its name, or else the only one in its folder.
std::optional<std::string> scenario_beside(const std::string& file);

}  // namespace throng
