#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "app/output/regression/cases.h"
#include "app/output/regression/outcome.h"

namespace throng::app {

/// Holds the values that all cases of a run share.
struct CheckPlan {
  const RegressionCases& all;
  std::string program;        ///< the program that draws: this one
  std::string typed;          ///< how a person calls `throng check` for one case, without its name
  std::filesystem::path out;  ///< the folder for drawn pictures
  std::string data;           ///< folder of shaders and assets; empty: where the program finds them
  bool update = false;        ///< expected pictures are written
};

/// Draws cases, each in a process of its own, since a process has one GL context.
class CaseDrawer {
 public:
  explicit CaseDrawer(CheckPlan plan) : plan_(std::move(plan)) {}

  /// Draws a case and compares it, or writes the expected picture. The first of several cases that share a picture
  /// writes it, and the others are held against it.
  CaseOutcome run(const RegressionCase& wanted, ContextKind context);

 private:
  std::string file_of(const CaseOutcome& outcome, const char* what) const;
  bool draw(const RegressionCase& wanted, CaseOutcome& outcome) const;
  void hold(const RegressionCase& wanted, CaseOutcome& outcome) const;
  void compare(const RegressionCase& wanted, const ComparedPicture& expected, const ComparedPicture& actual,
               CaseOutcome& outcome) const;
  void update(const RegressionCase& wanted, CaseOutcome& outcome);

  CheckPlan plan_;
  std::set<std::filesystem::path> written_;  // expected pictures of this run
};

}  // namespace throng::app
