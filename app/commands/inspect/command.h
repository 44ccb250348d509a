#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "app/settings/settings.h"
#include "engine/anim/import/import.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// The options of `throng inspect`.
struct InspectOptions {
  std::string model;
  std::vector<std::string> clips_from;   ///< files whose clips are added to the largest model
  anim::PlacementChoice placement = {};  ///< size and place of all models; what it leaves open is guessed
  import::ImportOptions reading{};
  TrajectoryOptions tracks{};         ///< how a file of trajectories is read, and the part of it that is measured
  std::string measures = {};          ///< a table of the people of trajectories; empty: none
  std::optional<float> cut_off = {};  ///< Tuning::density_cut_off; unset: as the demo has it
  std::optional<std::pair<glm::dvec2, glm::dvec2>> count_line = {};  ///< ends of a line whose passages are counted
  bool json = false;  ///< one JSON object on standard output instead of tables for a person
};

/// Runs `throng inspect`. Returns the exit status; a file that is refused gives one line on stderr.
int run_inspect(const InspectOptions& options);

}  // namespace throng::app
