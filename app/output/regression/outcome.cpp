#include "app/output/regression/outcome.h"

#include "engine/base/text/joined.h"

namespace throng::app {

RunCounts counts_of(const RegressionRun& run) {
  RunCounts counts{.all = run.outcomes.size()};
  for (const CaseOutcome& outcome : run.outcomes) {
    switch (outcome.verdict) {
      case Verdict::passed:
      case Verdict::same:
        ++counts.as_expected;
        break;
      case Verdict::failed:
        ++counts.failed;
        break;
      case Verdict::not_drawn:
        ++counts.not_drawn;
        break;
      case Verdict::left_out:
        ++counts.left_out;
        break;
      case Verdict::changed:
        ++counts.changed;
        break;
      case Verdict::added:
        ++counts.added;
        break;
    }
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
  std::string text = counted(counts.all, "picture") + ": " + std::to_string(counts.as_expected) + " as expected";
  const auto add = [&text](std::size_t count, const char* what) {
    if (count > 0) text += ", " + std::to_string(count) + " " + what;
  };
  add(counts.changed, "changed");
  add(counts.added, "new");
  add(counts.failed, "failed");
  add(counts.not_drawn, "not drawn");
  add(counts.left_out, "left out");
  return text;
}

}  // namespace throng::app
