#include "app/regression/outcome.h"

#include "app/files/joined.h"

namespace throng::app {

RunCounts counts_of(const RegressionRun& run) {
  RunCounts counts{.all = run.outcomes.size()};
  for (const CaseOutcome& outcome : run.outcomes) {
    counts.failed += outcome.verdict == Verdict::failed ? 1 : 0;
    counts.not_drawn += outcome.verdict == Verdict::not_drawn ? 1 : 0;
    counts.left_out += outcome.verdict == Verdict::left_out ? 1 : 0;
  }
  return counts;
}

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "ok";
    case Verdict::failed:
      return "FAILED";
    case Verdict::not_drawn:
      return "NOT DRAWN";
    case Verdict::left_out:
      return "left out";
    case Verdict::same:
      return "same";
    case Verdict::changed:
      return "changed";
    case Verdict::added:
      return "new";
  }
  return "";
}

std::string summary_of(const RegressionRun& run) {
  const RunCounts counts = counts_of(run);
  std::string text = counted(counts.all, "picture") + ": " +
                     std::to_string(counts.all - counts.failed - counts.not_drawn - counts.left_out) +
                     " as expected, " + std::to_string(counts.failed) + " failed";
  if (counts.not_drawn > 0) text += ", " + std::to_string(counts.not_drawn) + " not drawn";
  if (counts.left_out > 0) text += ", " + std::to_string(counts.left_out) + " left out";
  return text;
}

}  // namespace throng::app
