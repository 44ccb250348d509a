#pragma once

#include <string>
#include <vector>

namespace throng::app {

struct PlotBar {
  std::string name;
  double value = 0;
  bool emphasised = false;
};

/// Draws bars from left to right, the longest as wide as the room, each with its value, as a whole SVG file.
std::string bars_as_svg(const std::string& title, const std::string& unit, const std::vector<PlotBar>& bars);

struct PlotLine {
  std::string name;
  std::vector<double> x, y;  ///< of equal length, x ascending and above 0
  bool dashed = false;       ///< true for a line to compare others with
};

struct PlotStyle {
  bool logarithmic =
      false;              ///< the scale has powers of ten, for values above 0 that lie far apart; else it begins at 0
  std::string note = {};  ///< a line below the title
};

/// Draws lines over an axis of doublings, with a scale and names at their ends, as a whole SVG file.
std::string lines_as_svg(const std::string& title, const std::string& x_name, const std::string& y_name,
                         const std::vector<PlotLine>& lines, const PlotStyle& style = {});

}  // namespace throng::app
