// Below which size tasks are too small: tile by tile, and crowd by crowd.

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/bench/case.h"
#include "app/commands/bench/plot.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/commands/bench/turns.h"
#include "tests/benchmark/programs/bench_crowd.h"
#include "tests/benchmark/programs/program.h"

namespace throng::app {
namespace {

constexpr double counts_as_slower = 1.1;

void add(BenchRounds& rounds, BenchCrowd& crowd, const std::string& key, const anim::SystemOptions& options) {
  rounds.add({key, [&crowd] { crowd.subject.run(); }, [&crowd, options] { crowd.subject.configure(options); }});
}

/// Tiles from 1 to the widest that fits: the same work in ever smaller tasks.
Status sweep_tiles(const BenchOptions& options, const BenchCharacter& character, std::vector<Json>& rows) {
  const BenchCase bench = bench_cases(options).front();
  anim::SystemOptions system = bench_system_options(options, bench);
  system.tile = 0;
  auto crowd = BenchCrowd::create(character.character, system, bench_agents(*character.character, bench.agents));
  if (!crowd) return crowd.error();
  BenchRounds rounds;
  const int widest = crowd->system().figures().schedule().plan.width;
  for (int tile = 1; tile <= widest; tile *= 2) {
    system.tile = tile;
    add(rounds, *crowd, std::to_string(tile), system);
  }
  rounds.run(options.frames, "tiles: ");
  const int bones = character.character->skeleton.bone_count();
  for (int tile = 1; tile <= widest; tile *= 2) {
    const double agent_ns = rounds.times().median(std::to_string(tile)) / bench.agents;
    rows.push_back({{"tile", tile},
                    {"ns_per_bone_median", agent_ns / bones},
                    {"task_us", agent_ns * tile * crowd->system().figures().schedule().pus / 1000.0}});
  }
  return Done{};
}

/// Crowds of 1, 2, 4, ... agents, on one PU and on all: shows the size from which more PUs pay.
Status sweep_crowds(const BenchOptions& options, const BenchCharacter& character, std::vector<Json>& rows) {
  const BenchCase bench = bench_cases(options).front();
  anim::SystemOptions all = bench_system_options(options, bench);
  all.cost.least_task = 0;  // even the least work wakes every PU
  anim::SystemOptions one = all;
  one.pus = 1;
  for (int agents = 1; agents <= std::min(bench.agents, 1024); agents *= 2) {
    auto crowd = BenchCrowd::create(character.character, all, bench_agents(*character.character, agents));
    if (!crowd) return crowd.error();
    BenchRounds rounds;
    add(rounds, *crowd, "one", one);
    add(rounds, *crowd, "all", all);
    rounds.run(options.frames, std::to_string(agents) + " agents: ");
    rows.push_back({{"agents", agents},
                    {"one_pu_us", rounds.times().median("one") / 1000.0},
                    {"all_pus_us", rounds.times().median("all") / 1000.0},
                    {"speedup_over_one_pu", rounds.times().median_ratio("one", "all")}});
  }
  return Done{};
}

int smallest_tile(const std::vector<Json>& tiles) {
  auto best = tiles.front()["ns_per_bone_median"].get<double>();
  for (const Json& row : tiles) best = std::min(best, row["ns_per_bone_median"].get<double>());
  for (const Json& row : tiles) {
    if (row["ns_per_bone_median"].get<double>() <= counts_as_slower * best) return row["tile"].get<int>();
  }
  return 0;
}

/// The number of agents from which on more PUs are faster, and stay so.
Json first_faster_crowd(const std::vector<Json>& crowds) {
  Json first = nullptr;
  for (const Json& row : crowds) {
    const bool faster = row["speedup_over_one_pu"].get<double>() > counts_as_slower;
    if (faster && first.is_null()) first = row["agents"];
    if (!faster) first = nullptr;
  }
  return first;
}

std::string verdict(const Json& found) {
  char task[64];
  std::snprintf(task, sizeof(task), "%.3g microseconds", found["least_task_us"].get<double>());
  const Json& agents = found["least_agents_for_more_pus"];
  return "Tasks are too small below " + std::string(task) + ", a tile of " + found["least_tile"].dump() +
         (agents.is_null() ? "; more PUs never paid." : "; more PUs pay from " + agents.dump() + " agents on.");
}

Result<BenchReport> sweep_grain(const BenchOptions& options) {
  const BenchCase bench = bench_cases(options).front();
  const auto character = bench_character(options, bench.bones, bench.clips);
  if (!character) return character.error();
  std::vector<Json> tiles, crowds;
  if (const Status done = sweep_tiles(options, *character, tiles); !done) return done.error();
  if (const Status done = sweep_crowds(options, *character, crowds); !done) return done.error();

  const int least_tile = smallest_tile(tiles);
  const auto least = std::ranges::find_if(tiles, [&](const Json& row) { return row["tile"] == least_tile; });
  BenchReport report;
  report.json = {{"sweep", "grain"},
                 {"agents", bench.agents},
                 {"bones_per_agent", character->character->skeleton.bone_count()},
                 {"least_tile", least_tile},
                 {"least_task_us", (*least)["task_us"]},
                 {"least_agents_for_more_pus", first_faster_crowd(crowds)},
                 {"tiles", tiles},
                 {"crowds", crowds}};
  constexpr std::array tile_columns = {"tile", "ns_per_bone_median", "task_us"};
  constexpr std::array crowd_columns = {"agents", "one_pu_us", "all_pus_us", "speedup_over_one_pu"};
  report.text = figures_as_text(tiles, tile_columns) + "\n" + figures_as_text(crowds, crowd_columns) + "\n" +
                verdict(report.json) + "\n";
  PlotLine line{.name = "update", .x = {}, .y = {}};
  for (const Json& row : tiles) {
    line.x.push_back(row["tile"].get<double>());
    line.y.push_back(row["ns_per_bone_median"].get<double>());
  }
  report.plot = lines_as_svg("The grain of tasks", "characters a tile", "ns a bone", {line});
  return report;
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  return throng::app::run_bench_program(argument_count, arguments, throng::app::sweep_grain);
}
