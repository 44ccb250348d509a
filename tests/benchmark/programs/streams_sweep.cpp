// The resource that stays shared (paper 2.2.3, footnote 5): what it costs to read streams more often, or denser ones.

#include <array>
#include <memory>
#include <string>

#include "app/commands/bench/case.h"
#include "app/commands/bench/crowd.h"
#include "app/commands/bench/plot.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/commands/bench/turns.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/benchmark/programs/program.h"

namespace throng::app {
namespace {

constexpr std::array key_densities = {15, 30, 60, 120};  // keys a second
constexpr std::array steps_a_second = {240, 60, 15, 2};  // updates of a player in a second of its clip

std::size_t stream_bytes(const anim::Character& character, anim::StreamKind kind) {
  std::size_t bytes = 0;
  for (const anim::BakedClip& clip : character.clips) {
    const bool sampled = kind == anim::StreamKind::sampled && clip.sampled() != nullptr;
    bytes += sampled ? clip.sampled()->total_size : clip.keyframe()->total_size;
  }
  return bytes;
}

/// One key density: every step, each with prefetch and without.
Status sweep_steps(const BenchOptions& options, const BenchCase& bench, int keys, std::vector<Json>& rows) {
  const auto character = std::make_shared<const anim::Character>(
      anim::bake_character(anim::synthetic_model(bench.bones, bench.clips, 1, keys)));
  const std::vector<BenchAgent> agents = bench_agents(*character, bench.agents);
  const BenchPalettes palettes(bench.agents, character->skeleton.palette_count());
  anim::SystemOptions plain = bench_system_options(options, bench);
  plain.prefetch = false;
  anim::SystemOptions prefetched = plain;
  prefetched.prefetch = true;
  auto subject = SystemSubject::create(character, plain, agents, palettes);
  if (!subject) return subject.error();
  for (const int steps : steps_a_second) {
    BenchRounds rounds;
    subject->set_step(ticks_per_second / steps);
    const auto run = [&] { subject->run(); };
    rounds.add({"plain", run, [&] { subject->configure(plain); }});
    rounds.add({"prefetched", run, [&] { subject->configure(prefetched); }});
    rounds.run(options.frames, std::to_string(keys) + " keys a second, " + std::to_string(steps) + " steps: ");
    const double bones = static_cast<double>(bench.agents) * bench.bones;
    rows.push_back({{"keys_per_second", keys},
                    {"step_ms", 1000.0 / steps},
                    {"ns_per_bone_median", rounds.times().median("plain") / bones},
                    {"prefetched_ns_per_bone_median", rounds.times().median("prefetched") / bones},
                    {"prefetched_over_plain", rounds.times().median_ratio("prefetched", "plain")},
                    {"stream_bytes_per_frame", subject->system().figures().stream_bytes()},
                    {"stream_bytes_in_all", stream_bytes(*character, plain.stream)}});
  }
  return Done{};
}

std::string plot_of(const std::vector<Json>& rows) {
  std::vector<PlotLine> lines;
  for (const int steps : steps_a_second) {
    const double step_ms = 1000.0 / steps;
    for (const bool prefetched : {false, true}) {
      char name[48];
      std::snprintf(name, sizeof(name), "step %.3g ms%s", step_ms, prefetched ? ", prefetched" : "");
      PlotLine line{.name = name, .x = {}, .y = {}, .dashed = prefetched};
      for (const Json& row : rows) {
        if (row["step_ms"].get<double>() != step_ms) continue;
        line.x.push_back(row["keys_per_second"].get<double>());
        line.y.push_back(row[prefetched ? "prefetched_ns_per_bone_median" : "ns_per_bone_median"].get<double>());
      }
      lines.push_back(line);
    }
  }
  return lines_as_svg("What reading streams costs", "keys a second", "ns a bone", lines);
}

Result<BenchReport> sweep_streams(const BenchOptions& options) {
  if (!options.model.empty()) return Error{"the clips are built here; leave the model out"};
  const BenchCase bench = bench_cases(options).front();
  std::vector<Json> rows;
  for (const int keys : key_densities) {
    if (const Status done = sweep_steps(options, bench, keys, rows); !done) return done.error();
  }
  constexpr std::array columns = {"keys_per_second",       "step_ms",
                                  "ns_per_bone_median",    "prefetched_ns_per_bone_median",
                                  "prefetched_over_plain", "stream_bytes_per_frame",
                                  "stream_bytes_in_all"};
  return BenchReport{.text = figures_as_text(rows, columns),
                     .json = {{"sweep", "streams"},
                              {"agents", bench.agents},
                              {"bones_per_agent", bench.bones},
                              {"clips", bench.clips},
                              {"rows", rows}},
                     .plot = plot_of(rows)};
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  return throng::app::run_bench_program(argument_count, arguments, throng::app::sweep_streams);
}
