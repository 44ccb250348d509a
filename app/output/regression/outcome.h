#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/output/regression/origin.h"
#include "app/output/regression/tolerance.h"

namespace throng::app {

/// Says how a case went: drawn as expected, another picture or none to compare with, not drawn, left out, or written
/// anew.
enum class Verdict : std::uint8_t { passed, failed, not_drawn, left_out, same, changed, added };

/// One case in one context.
struct CaseOutcome {
  std::string name;
  std::string context;  ///< "egl", "osmesa"
  Verdict verdict = Verdict::passed;
  std::string message;                                       ///< what went wrong, or why it was left out; else empty
  std::vector<JudgedFigure> figures;                         ///< empty: nothing was compared
  std::string brief;                                         ///< the figures in a few words
  bool differs = false;                                      ///< in any pixel
  std::filesystem::path expected, actual, difference, heat;  ///< pictures; empty: there is none
  PictureOrigin expected_origin, actual_origin;
  double seconds = 0;
  std::string command;  ///< the command that draws it again
};

/// Returns whether a person has to look at the case.
inline bool is_bad(Verdict verdict) { return verdict == Verdict::failed || verdict == Verdict::not_drawn; }

/// All cases of a run.
struct RegressionRun {
  std::string title;  ///< the name of the file of cases
  std::vector<CaseOutcome> outcomes;
};

/// Returns how many cases have a verdict.
std::size_t count_of(const RegressionRun& run, Verdict verdict);

/// Returns the word for a verdict in lines and pages: "ok", "FAILED".
const char* word_of(Verdict verdict);

/// Returns "12 pictures: 9 as expected, 1 new, 1 failed, 1 not drawn"; kinds without a picture are left out.
std::string summary_of(const RegressionRun& run);

}  // namespace throng::app
