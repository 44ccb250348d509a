#include "tests/soak/program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/app/program_run.h"

namespace throng::soak {
namespace {

using Clock = std::chrono::steady_clock;

/// Waits for the end of a child, or for that time. Returns whether it has ended.
bool ends_within(std::chrono::milliseconds longest, pid_t child) {
  for (const auto end = Clock::now() + longest; !app::has_ended(child);) {
    if (Clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

void watch(pid_t child, const ProgramTime& time, ProgramRun& run) {
  const auto begin = Clock::now();
  bool interrupted = time.until_interrupt <= 0;
  while (!ends_within(std::chrono::milliseconds(100), child)) {
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    run.figures.push_back(figures_of(child));
    if (!interrupted && run.figures.back().computed > time.until_interrupt) {
      interrupted = true;
      kill(child, SIGINT);
    }
    if (!run.hung && seconds > time.until_killed) {
      run.hung = true;
      kill(child, SIGKILL);
    }
  }
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                       const ProgramTime& time) {
  ProgramRun run;
  const bool is_live = std::ranges::count(words, "-") > 0;  // tracks that come, which any_tracks wrote
  app::ProgramRun ended = app::run_program(words, {.input = is_live ? (folder / "tracks.csv").string() : "/dev/null",
                                                   .meanwhile = [&](pid_t child) { watch(child, time, run); },
                                                   .folder = folder.string()});
  run.status = ended.exit_status;
  run.output = std::move(ended.output);
  run.errors = std::move(ended.errors);
  return run;
}

std::string as_command(const std::vector<std::string>& words) {
  std::string command = "throng";
  for (const std::string& word : words) {
    const bool plain = word.find_first_of(" *#'\"()$") == std::string::npos;
    command += plain ? " " + word : " '" + word + "'";
  }
  return command;
}

}  // namespace throng::soak
