#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/commands/bench/options.h"
#include "app/commands/bench/times.h"
#include "app/figures/timeline_log.h"
#include "app/files/json.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Whom a benchmark animates: as imported or built, and baked.
struct BenchCharacter {
  anim::Model model;
  std::shared_ptr<const anim::Character> character;
};
anim::Result<BenchCharacter> bench_character(const std::string& model, int bones, int clips);

/// How a case is scheduled, without hashing.
anim::SystemOptions bench_system_options(const BenchOptions& options, const BenchCase& bench);

/// What is done of a case before the next one has its turn.
struct BenchPass {
  int rounds;
  bool is_last;
  std::string label;  ///< for a person at a terminal
};

/// Times whole update, bare kernels, their scalar twin, keyframe streams and write floor in interleaved rounds, and
/// puts them behind those of earlier passes in `times`. In the last pass `trace` gets some frames, and what is returned
/// is one flat object of figures of all passes, as the README lists them; before, null.
/// The error is a usage error, found before the first round.
anim::Result<Json> run_bench_case(const BenchOptions& options, const BenchCase& bench, const BenchCharacter& character,
                                  const BenchPass& pass, BenchTimes& times, std::optional<TimelineLog>& trace);

}  // namespace throng::app
