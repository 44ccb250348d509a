// The whole update on one PU beside ozz-animation over the same crowd, clips, times and weights, in turns.

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/bench/case.h"
#include "app/commands/bench/crowd.h"
#include "app/commands/bench/rounds.h"
#include "app/commands/bench/table.h"
#include "app/commands/bench/turns.h"
#include "tests/benchmark/programs/ozz_subject.h"
#include "tests/benchmark/programs/program.h"

namespace throng::app {
namespace {

anim::Result<Json> row_of(const BenchOptions& options, const BenchCase& bench) {
  const auto whom = bench_character(options, bench.bones, bench.clips);
  if (!whom) return whom.error();
  const anim::Character& character = *whom->character;
  const std::vector<BenchAgent> agents = bench_agents(character, bench.agents);
  const BenchPalettes palettes(bench.agents, character.skeleton.palette_count());
  auto update = SystemSubject::create(whom->character, bench_system_options(options, bench), agents, palettes);
  if (!update) return update.error();
  const auto ozz = make_ozz_subject(whom->model, agents, palettes);
  if (!ozz) return ozz.error();

  BenchRounds rounds;
  rounds.add({"ozz", [&] { (*ozz)->run(); }});
  rounds.add({"one pu", [&] { update->run(); }});
  rounds.run(options.frames, std::to_string(bench.agents) + " agents: ");
  const BenchTimes& times = rounds.times();
  const double bones = static_cast<double>(bench.agents) * character.skeleton.bone_count();
  return Json{{"agents", bench.agents},
              {"bones_per_agent", character.skeleton.bone_count()},
              {"clips", character.clips.size()},
              {"one_pu_ns_per_bone_median", times.median("one pu") / bones},
              {"ozz_ns_per_bone_median", times.median("ozz") / bones},
              {"ozz_over_one_pu", times.median_ratio("ozz", "one pu")}};
}

anim::Result<BenchReport> compare_with_ozz(const BenchOptions& options) {
  if (!options.plot.empty()) return anim::Error{"--plot: there is nothing to draw"};
  BenchOptions one_pu = options;
  one_pu.pus = {1};
  std::vector<Json> rows;
  for (const BenchCase& bench : bench_cases(one_pu)) {
    auto row = row_of(one_pu, bench);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  constexpr std::array columns = {
      "agents", "bones_per_agent", "clips", "one_pu_ns_per_bone_median", "ozz_ns_per_bone_median", "ozz_over_one_pu"};
  return BenchReport{.text = figures_as_text(rows, columns), .json = figures_as_json(rows), .plot = {}};
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  return throng::app::run_bench_program(argument_count, arguments, throng::app::compare_with_ozz);
}
