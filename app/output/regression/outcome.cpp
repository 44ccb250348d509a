#include "app/output/regression/outcome.h"

#include <algorithm>
#include <array>

#include "engine/base/text/joined.h"

namespace throng::app {

std::size_t count_of(const RegressionRun& run, Verdict verdict) {
  return static_cast<std::size_t>(std::ranges::count(run.outcomes, verdict, &CaseOutcome::verdict));
}

const char* word_of(Verdict verdict) {
  constexpr std::array words{"ok", "FAILED", "NOT DRAWN", "left out", "same", "changed", "new"};
  return words.at(static_cast<std::size_t>(verdict));
}

std::string summary_of(const RegressionRun& run) {
  const std::size_t as_expected = count_of(run, Verdict::passed) + count_of(run, Verdict::same);
  std::string text = counted(run.outcomes.size(), "picture") + ": " + std::to_string(as_expected) + " as expected";
  const auto add = [&](Verdict verdict, const char* what) {
    const std::size_t count = count_of(run, verdict);
    if (count > 0) text += ", " + std::to_string(count) + " " + what;
  };
  add(Verdict::changed, "changed");
  add(Verdict::added, "new");
  add(Verdict::failed, "failed");
  add(Verdict::not_drawn, "not drawn");
  add(Verdict::left_out, "left out");
  return text;
}

}  // namespace throng::app
