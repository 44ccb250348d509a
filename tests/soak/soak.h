#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/own_folder.h"
#include "tests/soak/growth.h"
#include "tests/soak/program_rounds.h"
#include "tests/soak/round.h"
#include "tests/soak/show_rounds.h"
#include "tests/soak/window_rounds.h"

namespace throng::soak {

struct SoakOptions {
  double minutes = 0;  ///< 0: the rounds are counted
  int rounds = 0;
  std::uint64_t first = 1;             ///< seed of the first round; each further one has the next number
  std::optional<std::uint64_t> again;  ///< repeat this seed alone
  int times = 8;                       ///< so many times
  bool headless = false;               ///< no rounds with a window
  bool tell = false;
};
std::optional<SoakOptions> read_options(const std::vector<std::string>& words);

/// Runs rounds and stops at the first fault.
class Soak {
 public:
  explicit Soak(const SoakOptions& options);

  /// Returns whether no round had a fault.
  bool run();

 private:
  using Clock = std::chrono::steady_clock;

  std::uint64_t seed_of(int round) const;
  bool is_over(int round) const;
  bool is_warm(int round) const;
  Fault run_round(std::uint64_t seed);
  Fault run_round(const RoundPlace& place);
  Fault measure(const ShowRounds& shows);
  void print_table(int rounds) const;

  SoakOptions options_;
  test::OwnFolder folder_;
  Models models_;
  ProgramRounds programs_{models_};
  ShowRounds shows_{models_, app::ContextKind::none}, drawn_shows_{models_, app::ContextKind::egl};
  std::optional<WindowRounds> windows_;  // none before the first round with one
  Growth growth_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace throng::soak
