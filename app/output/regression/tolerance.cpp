#include "app/output/regression/tolerance.h"

#include <algorithm>

#include "app/settings/option_values.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

/// A value above 0 is not rounded to 0.
std::string rounded(double value, int decimals) {
  std::string text = fixed(value, decimals);
  if (value == 0.0 || text.find_first_of("123456789") != std::string::npos) return text;
  return "below " + text.substr(0, text.size() - 1) + "1";
}

std::string percent(double share) { return rounded(100 * share, 2) + "%"; }

/// Returns a mean in the unit of the pictures' contents.
std::string amount(const PictureDifference& difference, double mean) {
  if (difference.kind == PixelKind::colours) return rounded(mean, 3);
  return difference.kind == PixelKind::depths ? rounded(mean, 3) + " m" : percent(mean);
}

/// Labels and numbers have no mean beside the share.
bool has_mean(const PictureDifference& difference) {
  return difference.kind == PixelKind::colours || difference.kind == PixelKind::depths;
}

std::string other_pixels(PixelKind kind) {
  if (kind != PixelKind::colours) return "have other " + pixel_kind_name(kind);
  return "differ by more than " + std::to_string(seen_steps) + " steps";
}

bool has_no_limit(const Tolerance& tolerance) { return !tolerance.mean && !tolerance.worst_block && !tolerance.share; }

/// Without any limit, two pictures must be equal.
DifferenceLimit no_difference() { return {.most = 0, .because = "no tolerance is given"}; }

JudgedFigure judged(const std::string& name, double value, const std::optional<DifferenceLimit>& limit,
                    const auto& text) {
  JudgedFigure figure{.name = name, .value = text(value), .limit = {}, .because = {}};
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

std::vector<JudgedFigure> judge(const PictureDifference& difference, const Tolerance& tolerance) {
  Tolerance limits = tolerance;
  if (has_no_limit(tolerance)) limits.mean = limits.worst_block = limits.share = no_difference();
  const auto steps = [&](double value) { return amount(difference, value); };
  const std::string others = difference.kind == PixelKind::colours
                                 ? "share of pixels off by more than " + std::to_string(seen_steps) + " steps"
                                 : "share of pixels that " + other_pixels(difference.kind);
  std::vector<JudgedFigure> figures;
  if (has_mean(difference)) figures.push_back(judged("mean", difference.mean, limits.mean, steps));
  figures.push_back(judged("worst block", difference.worst_block, limits.worst_block, [&](double value) {
    return value == 0 ? steps(value) : steps(value) + " at " + place_of_block(difference);
  }));
  figures.push_back(judged(others, difference.share, limits.share, percent));
  if (!figures.back().limit.empty()) figures.back().limit = percent(limits.share->most);
  return figures;
}

bool all_within(const std::vector<JudgedFigure>& figures) {
  return std::ranges::all_of(figures, &JudgedFigure::is_within);
}

std::string unfit_limits(const PictureDifference& difference, const Tolerance& tolerance) {
  const bool has_steps = tolerance.mean || tolerance.worst_block;
  if (difference.kind == PixelKind::colours || !has_steps) return {};
  return "limits of mean and worst block are steps of colours, and the pictures hold " +
         pixel_kind_name(difference.kind) + "; limit the share alone";
}

std::string figures_text(const PictureDifference& difference) {
  if (difference.is_none()) return "no pixel differs";
  const std::string mean = has_mean(difference) ? "mean " + amount(difference, difference.mean) + ", " : "";
  return mean + "worst block " + amount(difference, difference.worst_block) + " at " + place_of_block(difference) +
         ", " + percent(difference.share) + " of pixels " + other_pixels(difference.kind);
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
