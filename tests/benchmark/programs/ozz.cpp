// The whole update on one PU in turns with other libraries over the same crowd, clips, times and weights: with
// ozz-animation and with the Animation Compression Library, whichever were installed when this was built.

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/bench/case.h"
#include "app/commands/bench/crowd.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/commands/bench/turns.h"
#include "app/commands/inspect/report.h"
#include "tests/benchmark/programs/acl_subject.h"
#include "tests/benchmark/programs/ozz_subject.h"
#include "tests/benchmark/programs/pose_agreement.h"
#include "tests/benchmark/programs/program.h"

namespace throng::app {
namespace {

constexpr const char* names[] = {"ozz", "acl"};

/// Libraries keep to their bounds at samples alone, and ozz-animation joint by joint, so poses differ by a millimetre.
constexpr double tolerance_mm = 2.0;

/// Returns the subject if it shows the poses that ours shows, else null. Says in `row` how far it is off, and why it
/// has no figures.
template <typename Subject>
std::unique_ptr<Subject> agreeing(const std::string& name, Result<std::unique_ptr<Subject>> made,
                                  const PoseAgreement& ours, Json& row) {
  row[name + "_off_mm"] = nullptr;
  if (!made) {
    row[name + "_missing"] = made.error().message;
    return nullptr;
  }
  (*made)->run();
  const double off_mm = 1000.0 * ours.off_by();
  row[name + "_off_mm"] = off_mm;
  if (off_mm <= tolerance_mm) return std::move(*made);
  row[name + "_missing"] = "it shows other poses than ours with this model";
  return nullptr;
}

std::size_t bytes_of_clips(const anim::Character& character) {
  std::size_t sum = 0;
  for (const anim::BakedClip& clip : character.clips) sum += bytes_played(clip);
  return sum;
}

/// Adds what was timed; what was not is null.
void add_times(Json& row, const BenchTimes& times, double bones) {
  const auto add = [&](const std::string& key, const std::string& subject) {
    row[key + "_ns_per_bone_median"] = times.has(subject) ? Json(times.median(subject) / bones) : Json(nullptr);
  };
  add("one_pu", "one pu");
  for (const char* const name : names) add(name, name);
  add("acl_sample", "acl sample");
  for (const char* const name : names) {
    row[name + std::string("_over_one_pu")] =
        times.has(name) ? Json(times.median_ratio(name, "one pu")) : Json(nullptr);
  }
}

Result<Json> row_of(const BenchOptions& options, const BenchCase& bench) {
  const auto whom = bench_character(options, bench.bones, bench.clips);
  if (!whom) return whom.error();
  const anim::Character& character = *whom->character;
  const std::vector<BenchAgent> agents = bench_agents(character, bench.agents);
  const BenchPalettes palettes(bench.agents, character.skeleton.palette_count());
  auto update = SystemSubject::create(whom->character, bench_system_options(options, bench), agents, palettes);
  if (!update) return update.error();

  Json row{{"agents", bench.agents},
           {"bones_per_agent", character.skeleton.bone_count()},
           {"clips", character.clips.size()}};
  update->run();
  const PoseAgreement ours(whom->model, palettes, agents.size());
  const auto ozz = agreeing("ozz", make_ozz_subject(*whom, agents, palettes), ours, row);
  const auto acl = agreeing("acl", make_acl_subject(*whom, agents, palettes), ours, row);

  BenchRounds rounds;
  if (ozz) rounds.add({"ozz", [&] { ozz->run(); }});
  if (acl) rounds.add({"acl", [&] { acl->run(); }});
  if (acl) rounds.add({"acl sample", [&] { acl->sample(); }});
  rounds.add({"one pu", [&] { update->run(); }});
  rounds.run(options.frames, std::to_string(bench.agents) + " agents: ");
  add_times(row, rounds.times(), static_cast<double>(bench.agents) * character.skeleton.bone_count());
  row["clip_bytes"] = bytes_of_clips(character);
  row["ozz_bytes"] = ozz ? Json(ozz->bytes()) : Json(nullptr);
  row["acl_bytes"] = acl ? Json(acl->bytes()) : Json(nullptr);
  return row;
}

/// Says why a library has no figures in some row, one line each.
std::string missing_text(std::span<const Json> rows) {
  std::string text;
  for (const char* const name : names) {
    const std::string key = name + std::string("_missing");
    const auto found = std::ranges::find_if(rows, [&](const Json& row) { return row.contains(key); });
    if (found != rows.end()) text += name + std::string(": ") + (*found)[key].get<std::string>() + "\n";
  }
  return text;
}

Result<BenchReport> compare_with_libraries(const BenchOptions& options) {
  if (!options.plot.empty()) return Error{"--plot: there is nothing to draw"};
  BenchOptions one_pu = options;
  one_pu.pus = {1};
  std::vector<Json> rows;
  for (const BenchCase& bench : bench_cases(one_pu)) {
    auto row = row_of(one_pu, bench);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  constexpr std::array columns = {"agents",
                                  "bones_per_agent",
                                  "clips",
                                  "one_pu_ns_per_bone_median",
                                  "ozz_ns_per_bone_median",
                                  "acl_ns_per_bone_median",
                                  "acl_sample_ns_per_bone_median",
                                  "ozz_over_one_pu",
                                  "acl_over_one_pu",
                                  "clip_bytes",
                                  "ozz_bytes",
                                  "acl_bytes"};
  return BenchReport{
      .text = figures_as_text(rows, columns) + missing_text(rows), .json = figures_as_json(rows), .plot = {}};
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  return throng::app::run_bench_program(argument_count, arguments, throng::app::compare_with_libraries);
}
