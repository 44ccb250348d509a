#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/output/regression/compare.h"

namespace throng::app {

/// The most that a figure may be, with the reason.
struct DifferenceLimit {
  double most = 0.0;
  std::string because;
};

/// Says how far a picture may be from the expected one. Without any limit, no pixel may differ; else the given limits
/// count.
struct Tolerance {
  std::optional<DifferenceLimit> mean = {}, worst_block = {};  ///< steps of 255
  std::optional<DifferenceLimit> share = {};                   ///< 0 to 1
};

/// A figure of a difference beside its limit, as text.
struct JudgedFigure {
  std::string name;     ///< "worst block"
  std::string value;    ///< "12.400 at 320,160", "0.13%"
  std::string limit;    ///< "9"; empty: there is none
  std::string because;  ///< the reason of the limit
  bool is_within = true;
};

/// Returns mean, worst block and share, in this order; of labels and numbers no mean.
std::vector<JudgedFigure> judge(const PictureDifference& difference, const Tolerance& tolerance);

/// Returns whether all are within their limits.
bool all_within(const std::vector<JudgedFigure>& figures);

/// Returns why limits do not suit these pictures: steps of 255 say nothing of numbers. Empty if they do.
std::string unfit_limits(const PictureDifference& difference, const Tolerance& tolerance);

/// Returns "mean 0.030, worst block 1.200 at 320,160, 0.01% of pixels differ by more than 16 steps", or that no pixel
/// differs.
std::string figures_text(const PictureDifference& difference);

/// Returns the figures beyond their limits: "mean 3 of at most 0.8 (outlines move)".
std::string excess_text(const std::vector<JudgedFigure>& figures);

}  // namespace throng::app
