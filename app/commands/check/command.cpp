#include "app/commands/check/command.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "throng/render/context.h"

#include "app/commands/check/drawn_case.h"
#include "app/commands/check/git.h"
#include "app/files/exit_status.h"
#include "app/files/nearest_names.h"
#include "app/files/program_words.h"
#include "app/output/regression/cases.h"
#include "app/output/regression/junit.h"
#include "app/output/regression/outcome.h"
#include "app/output/regression/page.h"
#include "engine/base/files/child_process.h"
#include "engine/base/files/output_file.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

/// Returns the cases that the options name. Errors: there is no case of a name.
Result<std::vector<RegressionCase>> chosen(const RegressionCases& all, const CheckOptions& options) {
  if (options.names.empty()) return all.cases;
  std::vector<std::string> known;
  for (const RegressionCase& each : all.cases) known.push_back(each.name);
  std::vector<RegressionCase> cases;
  for (const std::string& name : options.names) {
    const auto found = std::ranges::find(all.cases, name, &RegressionCase::name);
    if (found == all.cases.end()) {
      return Error{"--case " + name + ": " + options.cases + " has no such case; near to it are " +
                   nearest_names(name, known)};
    }
    cases.push_back(*found);
  }
  return cases;
}

CaseOutcome left_out(const RegressionCase& wanted) {
  CaseOutcome outcome;
  outcome.name = wanted.name;
  outcome.context = "osmesa";
  outcome.verdict = Verdict::left_out;
  outcome.message = "OSMesa is not installed";
  return outcome;
}

std::string line_of(const CaseOutcome& outcome) {
  constexpr std::size_t width = 9;
  std::string word = word_of(outcome.verdict);
  word.resize(std::max(word.size(), width), ' ');
  std::string line = word + " " + outcome.name + " (" + outcome.context + ")";
  if (!outcome.message.empty()) {
    line += ": " + outcome.message;
  } else if (!outcome.brief.empty()) {
    line += ": " + outcome.brief;
  } else if (!outcome.expected.empty()) {
    line += ": " + outcome.expected.string();
  }
  return line + "\n";
}

/// Says which pictures --update would replace for good; an empty text if git can bring all back.
std::string danger_of_update(const std::vector<RegressionCase>& cases, const CheckOptions& options) {
  if (!options.update || options.force) return {};
  std::vector<fs::path> files;
  for (const RegressionCase& each : cases) {
    if (std::ranges::find(files, each.expected) == files.end()) files.push_back(each.expected);
  }
  const auto missing = missing_in_git(files);
  return missing ? "--update: " + *missing + "; --force replaces them all the same" : std::string();
}

Status write_reports(const RegressionRun& run, const CheckOptions& options, const fs::path& report) {
  if (Status written = write_page(run, report); !written) return written;
  return options.junit.empty() ? Done{} : write_whole_file(options.junit, junit_xml(run));
}

/// Draws all cases, with a line each, and reports.
Status check_all(const std::vector<RegressionCase>& cases, const CheckOptions& options, CheckPlan plan) {
  const fs::path report = options.report.empty() ? plan.out / "report.html" : fs::path(options.report);
  RegressionRun run{.title = fs::path(options.cases).stem().string(), .outcomes = {}};
  CaseDrawer drawer(std::move(plan));
  for (const RegressionCase& each : cases) {
    for (const ContextKind context : options.contexts.empty() ? each.contexts : options.contexts) {
      const bool can = context != ContextKind::osmesa || render::gl::osmesa_is_installed();
      run.outcomes.push_back(can ? drawer.run(each, context) : left_out(each));
      if (Status told = print(line_of(run.outcomes.back())); !told) return told;
    }
  }
  if (Status written = write_reports(run, options, report); !written) return written;
  const std::string summary = summary_of(run) + "; see " + report.string();
  const auto is_bad_case = [](const CaseOutcome& outcome) { return is_bad(outcome.verdict); };
  if (std::ranges::any_of(run.outcomes, is_bad_case)) return Error{summary};
  return print(summary + "\n");
}

}  // namespace

int run_check(const CheckOptions& options) {
  const bool asks_for_osmesa = std::ranges::find(options.contexts, ContextKind::osmesa) != options.contexts.end();
  if (asks_for_osmesa && !render::gl::osmesa_is_installed()) {
    return end_with(exit_usage, "--context: OSMesa is not installed; use --context egl");
  }
  const auto all = read_cases(options.cases);
  if (!all) return end_with(exit_usage, all.error().message);
  const auto cases = chosen(*all, options);
  if (!cases) return end_with(exit_usage, cases.error().message);
  const auto program = own_program();
  if (!program) return end_with(program);
  std::error_code error;
  const fs::path out = fs::absolute(options.out, error);
  fs::create_directories(out, error);
  if (error) return end_with(exit_job_failed, "--out " + options.out + ": cannot be made: " + error.message());
  if (const std::string danger = danger_of_update(*cases, options); !danger.empty()) {
    return end_with(exit_job_failed, danger);
  }
  return end_with(check_all(*cases, options,
                            {.all = *all,
                             .program = *program,
                             .typed = as_typed({"throng", "check", options.cases}),
                             .out = out,
                             .data = options.data.empty() ? "" : fs::absolute(options.data, error).string(),
                             .update = options.update}));
}

}  // namespace throng::app
