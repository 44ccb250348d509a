#include "app/regression/tolerance.h"

#include <algorithm>

#include "app/files/joined.h"
#include "app/settings/option_values.h"

namespace throng::app {
namespace {

std::string percent(double share) { return fixed(100 * share, 2) + "%"; }

bool has_no_limit(const Tolerance& tolerance) { return !tolerance.mean && !tolerance.worst_block && !tolerance.share; }

/// Without any limit, two pictures must be the same.
DifferenceLimit no_difference() { return {.most = 0, .because = "no tolerance is given"}; }

JudgedFigure judged(std::string name, double value, const std::optional<DifferenceLimit>& limit, auto text) {
  JudgedFigure figure{.name = std::move(name), .value = text(value), .limit = {}, .because = {}};
  if (!limit) return figure;
  figure.limit = shortest_text(limit->most);
  figure.because = limit->because;
  figure.is_within = value <= limit->most;
  return figure;
}

std::string place_of_block(const PictureDifference& difference) {
  return std::to_string(difference.worst_block_x) + "," + std::to_string(difference.worst_block_y);
}

}  // namespace

std::vector<JudgedFigure> judge(const PictureDifference& difference, const Tolerance& given) {
  Tolerance tolerance = given;
  if (has_no_limit(given)) tolerance.mean = tolerance.worst_block = tolerance.share = no_difference();
  const auto steps = [](double value) { return fixed(value, 3); };
  std::vector<JudgedFigure> figures;
  figures.push_back(judged("mean", difference.mean, tolerance.mean, steps));
  figures.push_back(judged("worst block", difference.worst_block, tolerance.worst_block, [&](double value) {
    return value == 0 ? steps(value) : steps(value) + " at " + place_of_block(difference);
  }));
  figures.push_back(judged("share of pixels off by more than " + std::to_string(seen_steps) + " steps",
                           difference.share, tolerance.share, percent));
  if (!figures.back().limit.empty()) figures.back().limit = percent(tolerance.share->most);
  return figures;
}

bool all_within(const std::vector<JudgedFigure>& figures) {
  return std::ranges::all_of(figures, &JudgedFigure::is_within);
}

std::string figures_text(const PictureDifference& difference) {
  if (difference == PictureDifference()) return "no pixel differs";
  return "mean " + fixed(difference.mean, 3) + ", worst block " + fixed(difference.worst_block, 3) + " at " +
         place_of_block(difference) + ", " + percent(difference.share) + " of pixels differ by more than " +
         std::to_string(seen_steps) + " steps";
}

std::string excess_text(const std::vector<JudgedFigure>& figures) {
  std::vector<std::string> parts;
  for (const JudgedFigure& figure : figures) {
    if (figure.is_within) continue;
    parts.push_back(figure.name + " " + figure.value + ", at most " + figure.limit + " (" + figure.because + ")");
  }
  return joined(parts, "; ", "; ");
}

}  // namespace throng::app
