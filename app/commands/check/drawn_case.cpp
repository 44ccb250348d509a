#include "app/commands/check/drawn_case.h"

#include <chrono>
#include <system_error>
#include <utility>

#include "app/files/program_words.h"
#include "engine/base/files/child_process.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

const char* name_of(ContextKind context) { return context == ContextKind::osmesa ? "osmesa" : "egl"; }

void fail(CaseOutcome& outcome, Verdict verdict, const std::string& message) {
  outcome.verdict = verdict;
  outcome.message = message;
}

/// Returns the last line of a run that failed, without the program's name.
std::string last_words(const std::string& errors) {
  const std::string line = last_line(errors), name = "throng: ";
  return plain_text(line.starts_with(name) ? line.substr(name.size()) : line);
}

std::string why_it_failed(const EndedChild& ended) {
  constexpr int signal_from = 128, alarm = signal_from + 14;
  if (ended.status == alarm) return "it had not ended after ten minutes";
  if (ended.status >= signal_from) return "signal " + std::to_string(ended.status - signal_from) + " ended it";
  const std::string line = last_words(ended.errors);
  return line.empty() ? "it ended with " + std::to_string(ended.status) + " and said nothing" : line;
}

}  // namespace

std::string CaseDrawer::file_of(const CaseOutcome& outcome, const char* what) const {
  return (plan_.out / (outcome.name + "-" + outcome.context + "-" + what + ".png")).string();
}

CaseOutcome CaseDrawer::run(const RegressionCase& wanted, ContextKind context) {
  CaseOutcome outcome;
  outcome.name = wanted.name;
  outcome.context = name_of(context);
  const auto start = std::chrono::steady_clock::now();
  if (draw(wanted, outcome)) {
    outcome.actual_origin = read_origin(outcome.actual);
    if (plan_.update && !written_.contains(wanted.expected)) {
      update(wanted, outcome);
    } else {
      hold(wanted, outcome);
    }
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

/// Returns whether there is a picture. A picture of an earlier run must not pass for it.
bool CaseDrawer::draw(const RegressionCase& wanted, CaseOutcome& outcome) const {
  for (const char* const what : {"actual", "difference", "heat"}) {
    std::error_code error;
    fs::remove(file_of(outcome, what), error);
  }
  std::vector<std::string> words{"throng"};
  words.insert(words.end(), wanted.words.begin(), wanted.words.end());
  words.insert(words.end(),
               {"--headless=" + outcome.context, "--software", "--screenshot", file_of(outcome, "actual")});
  if (!plan_.data.empty()) words.insert(words.end(), {"--data", plan_.data});
  outcome.command = "cd " + as_typed({plan_.all.folder.string()}) + " && " + as_typed(words);
  words.front() = plan_.program;
  const auto ended = run_child(words, {.folder = plan_.all.folder});
  if (!ended || ended->status != 0) {
    fail(outcome, Verdict::not_drawn, ended ? why_it_failed(*ended) : ended.error().message);
    return false;
  }
  outcome.actual = file_of(outcome, "actual");
  return true;
}

void CaseDrawer::hold(const RegressionCase& wanted, CaseOutcome& outcome) const {
  const auto actual = read_compared(outcome.actual);
  if (!actual) return fail(outcome, Verdict::not_drawn, actual.error().message);
  std::error_code error;
  if (!fs::exists(wanted.expected, error)) {
    return fail(outcome, Verdict::failed,
                "there is no expected picture " + wanted.expected.string() + "; look at " + outcome.actual.string() +
                    ", and if it is right, make it with: " + plan_.typed + " --case " + wanted.name + " --update");
  }
  const auto expected = read_compared(wanted.expected);
  if (!expected) return fail(outcome, Verdict::failed, expected.error().message);
  outcome.expected = wanted.expected;
  outcome.expected_origin = read_origin(wanted.expected);
  compare(wanted, rounded_to_bits(*expected, plan_.all.bits), rounded_to_bits(*actual, plan_.all.bits), outcome);
}

void CaseDrawer::compare(const RegressionCase& wanted, const ComparedPicture& expected, const ComparedPicture& actual,
                         CaseOutcome& outcome) const {
  const std::string other = other_origin(outcome.expected_origin, outcome.actual_origin);
  const std::string first = other.empty() ? "" : other + "; ";
  const auto difference = measure_difference(expected, actual);
  if (!difference) return fail(outcome, Verdict::failed, first + difference.error().message);
  outcome.figures = judge(*difference, wanted.tolerance);
  outcome.differs = !difference->is_none();
  outcome.brief = figures_text(*difference);
  if (all_within(outcome.figures)) return;
  outcome.difference = file_of(outcome, "difference");
  outcome.heat = file_of(outcome, "heat");
  fail(outcome, Verdict::failed, first + excess_text(outcome.figures) + "; see " + outcome.heat.string());
  for (const auto& [file, picture] : {std::pair{&outcome.difference, paint_difference(expected, actual)},
                                      std::pair{&outcome.heat, paint_heat(expected, actual, *difference)}}) {
    if (const auto written = render::write_png(picture, *file); !written) {
      outcome.message += "; " + written.error().message;
      file->clear();
    }
  }
}

void CaseDrawer::update(const RegressionCase& wanted, CaseOutcome& outcome) {
  const auto drawn = render::read_png(outcome.actual);
  if (!drawn) return fail(outcome, Verdict::not_drawn, drawn.error().message);
  const render::Image picture = rounded_to_bits(*drawn, plan_.all.bits);
  const auto before = read_compared(wanted.expected);
  const auto difference = before ? measure_difference(*before, picture) : before.error();
  outcome.expected = wanted.expected;
  written_.insert(wanted.expected);
  if (difference && difference->is_none()) {
    outcome.verdict = Verdict::same;
    outcome.expected_origin = read_origin(wanted.expected);
    return;
  }
  std::error_code error;
  outcome.verdict = fs::exists(wanted.expected, error) ? Verdict::changed : Verdict::added;
  fs::create_directories(wanted.expected.parent_path(), error);
  const auto written = render::write_png(picture, wanted.expected, texts_of(outcome.actual_origin));
  if (!written) fail(outcome, Verdict::failed, written.error().message);
  outcome.expected_origin = outcome.actual_origin;
}

}  // namespace throng::app
