#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/commands/bench/command.h"
#include "app/commands/bench/rounds.h"
#include "app/show/figures/timeline_log.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/model.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// The character that a benchmark animates: imported or built, then baked.
struct BenchCharacter {
  anim::Model model;
  std::shared_ptr<const anim::Character> character;
};
Result<BenchCharacter> bench_character(const BenchOptions& options, int bones, int clips);

/// Returns the options of the system for a case, without hashing.
anim::SystemOptions bench_system_options(const BenchOptions& options, const BenchCase& bench);

/// The part of a case that runs before the next case has its turn.
struct BenchPass {
  int rounds;
  bool is_last;
  std::string label;  ///< for a person at a terminal
};

/// Times the whole update, the bare kernels, their scalar twin, keyframe streams and the write floor in interleaved
/// rounds, and puts the times behind the times of earlier passes in `times`. The last pass gives `trace` some frames
/// and returns one flat object of the figures of all passes, as the README lists them; earlier passes return null. The
/// error is a usage error, found before the first round.
Result<Json> run_bench_case(const BenchOptions& options, const BenchCase& bench, const BenchCharacter& character,
                            const BenchPass& pass, BenchTimes& times, std::optional<TimelineLog>& trace);

}  // namespace throng::app
