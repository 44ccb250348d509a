#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "app/show/report/frame_report.h"

namespace throng::app {

/// A colour of the picture and its meaning.
struct LegendStep {
  std::uint32_t color = 0;    ///< as it is drawn (app/settings/agent_colors.h); 0: nothing is laid over the agent
  std::string words;          ///< the values in force that have it
  std::optional<int> agents;  ///< in view, that have it now; nothing: not counted
};

/// A word below a bar of colours.
struct LegendTick {
  float share = 0.0F;  ///< of the bar, from its left
  std::string words;
};

/// A bar of colours that go over into each other.
struct LegendRamp {
  std::vector<std::uint32_t> colors;  ///< at even distances, from the left to the right
  std::vector<LegendTick> ticks;
};

/// The meaning of the colours of one scale.
struct LegendPart {
  std::string title;
  std::vector<LegendStep> steps;
  std::optional<LegendRamp> ramp = {};  ///< shown below the title
  std::vector<std::string> notes = {};  ///< lines about all of it
};

/// Returns the meanings of the colours in the picture, with the numbers in force; nothing while there are none. Values
/// of one colour share a step. `heads_shown` is how many figures above heads had room.
std::vector<LegendPart> legend_of(const FrameReport& report, const Tuning& tuning, std::size_t heads_shown = 0);

}  // namespace throng::app
