#include "app/output/regression/junit.h"

#include "app/output/regression/markup.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

std::string attribute(const std::string& name, const std::string& value) {
  return ' ' + name + "=\"" + escaped(value) + '"';
}

std::string counts_as_attributes(const RegressionRun& run) {
  const auto count = [&](Verdict verdict) { return std::to_string(count_of(run, verdict)); };
  double seconds = 0;
  for (const CaseOutcome& outcome : run.outcomes) seconds += outcome.seconds;
  return attribute("tests", std::to_string(run.outcomes.size())) + attribute("failures", count(Verdict::failed)) +
         attribute("errors", count(Verdict::not_drawn)) + attribute("skipped", count(Verdict::left_out)) +
         attribute("time", fixed(seconds, 3));
}

/// Returns the element inside a test case that says how it ended; empty if it went well.
std::string end_of(const CaseOutcome& outcome) {
  const std::string said = attribute("message", outcome.message);
  if (outcome.verdict == Verdict::left_out) return "<skipped" + said + "/>";
  if (!is_bad(outcome.verdict)) return {};
  const std::string element = outcome.verdict == Verdict::failed ? "failure" : "error";
  std::string lines = outcome.message + "\n";
  for (const JudgedFigure& figure : outcome.figures) {
    lines += figure.name + ": " + figure.value + (figure.limit.empty() ? "" : ", at most " + figure.limit) + "\n";
  }
  lines += "command: " + outcome.command + "\n";
  std::string inside;
  for (std::size_t from = 0; from < lines.size();) {  // a line each, since an escaped text is one line
    const std::size_t end = lines.find('\n', from);
    inside += escaped(std::string_view(lines).substr(from, end - from)) + "\n";
    from = end + 1;
  }
  return "<" + element + said + attribute("type", word_of(outcome.verdict)) + ">" + inside + "</" + element + ">";
}

}  // namespace

std::string junit_xml(const RegressionRun& run) {
  const std::string counts = counts_as_attributes(run);
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts + ">\n  <testsuite" +
                    attribute("name", run.title) + counts + ">\n";
  for (const CaseOutcome& outcome : run.outcomes) {
    xml += "    <testcase" + attribute("name", outcome.name) +
           attribute("classname", run.title + "." + outcome.context) + attribute("time", fixed(outcome.seconds, 3));
    const std::string end = end_of(outcome);
    xml += end.empty() ? "/>\n" : ">" + end + "</testcase>\n";
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace throng::app
