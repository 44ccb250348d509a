#pragma once

#include <string>

#include "tests/soak/command_lines.h"
#include "tests/soak/program.h"
#include "tests/soak/round.h"

namespace throng::soak {

/// Rounds with the real program: it runs with any options and records; it repeats the recording with another scheduling
/// and must give the same poses, events and places. Other rounds give it packs, or let one process run for long.
class ProgramRounds {
 public:
  explicit ProgramRounds(const Models& models) : models_(&models) {}

  Fault run(const RoundPlace& place);

  /// Returns a line for each kind of round, and for each reason why the program refused a line.
  std::string table() const { return table_of("program", counts_); }

 private:
  Fault record_and_replay(const RoundPlace& place, Random& random);
  Fault play_a_pack(const RoundPlace& place, Random& random);
  Fault run_for_long(const RoundPlace& place, Random& random);
  Fault run_a_tool(const RoundPlace& place, Random& random);

  /// Runs the program. A fault is a crash, a hang, other words than one line of refusal, or a refusal where
  /// `must_work`.
  Fault run(const std::vector<std::string>& words, const RoundPlace& place, ProgramRun& run, bool must_work);
  /// Runs the program with options of scheduling, or without them if they do not fit.
  Fault run_scheduled(const std::vector<std::string>& words, const std::vector<std::string>& scheduling,
                      const RoundPlace& place, ProgramRun& run);
  Fault replay(const RoundPlace& place, Random& random);

  const Models* models_;
  Counts counts_;
};

}  // namespace throng::soak
