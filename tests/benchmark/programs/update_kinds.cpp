// Updates of other kinds over one that writes palettes alone, on one PU: a gaze and noise on every agent, which is a
// held program; listed joints in place of palettes; a thing in the hand of every tenth agent.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/commands/bench/case.h"
#include "app/commands/bench/crowd.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/commands/bench/turns.h"
#include "tests/benchmark/programs/held.h"
#include "tests/benchmark/programs/joints.h"
#include "tests/benchmark/programs/program.h"
#include "tests/benchmark/programs/sockets.h"

namespace throng::app {
namespace {

constexpr int agents_a_thing = 10;

Result<BenchReport> measure_kinds(const BenchOptions& options) {
  const BenchCase bench = bench_cases(options).front();
  const auto whom = bench_character(options, bench.bones, bench.clips);
  if (!whom) return whom.error();
  anim::SystemOptions one_pu = bench_system_options(options, bench);
  one_pu.pus = 1;
  one_pu.palettes = PaletteFormat::matrices;
  const anim::Skeleton& skeleton = whom->character->skeleton;
  const std::vector<BenchAgent> agents = bench_agents(*whom->character, bench.agents);
  const BenchPalettes palettes(bench.agents, skeleton.palette_count());
  auto update = SystemSubject::create(whom->character, one_pu, agents, palettes);
  if (!update) return update.error();

  BenchRounds rounds;
  std::vector<std::string> kinds;
  const auto add = [&](const std::string& kind, auto subject) {
    if (subject == nullptr) return;
    kinds.push_back(kind);
    rounds.add({kind, [made = std::shared_ptr(std::move(subject))] { made->run(); }});
  };
  const auto joints = [&](const anim::JointList& list, JointFormat format) {
    return JointSubject::create(whom->character, one_pu, agents, palettes, list, format);
  };
  const auto sockets = [&](SocketSource source) {
    const auto things = static_cast<std::size_t>((bench.agents + agents_a_thing - 1) / agents_a_thing);
    return SocketSubject::create(whom->character, one_pu, agents, palettes, things, source);
  };
  add("held", HeldSubject::create(whom->model, whom->character, one_pu, agents, palettes));
  if (skeleton.rigid) add("joints", joints(all_joints(skeleton), JointFormat::transforms));
  add("joint_matrices", joints(all_joints(skeleton), JointFormat::matrices));
  add("few_joints", joints(three_joints(skeleton), JointFormat::matrices));
  add("sockets", sockets(SocketSource::palette));
  add("listed_sockets", sockets(SocketSource::list));
  rounds.add({"one_pu", [&] { update->run(); }});
  rounds.run(options.frames, "kinds of updates: ");

  const double bones = static_cast<double>(bench.agents) * skeleton.bone_count();
  BenchReport report;
  report.json = {{"agents", bench.agents},
                 {"bones_per_agent", skeleton.bone_count()},
                 {"one_pu_ns_per_bone_median", rounds.times().median("one_pu") / bones}};
  for (const std::string& kind : kinds) {
    report.json[kind + "_ns_per_bone_median"] = rounds.times().median(kind) / bones;
    report.json[kind + "_over_one_pu"] = rounds.times().median_ratio(kind, "one_pu");
  }
  report.text = figures_as_text(std::span(&report.json, 1), {});
  return report;
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  return throng::app::run_bench_program(argument_count, arguments, throng::app::measure_kinds);
}
