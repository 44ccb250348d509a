#include "tests/benchmark/programs/machine.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/bench/case.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/settings/choices.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/benchmark/programs/bench_crowd.h"

namespace throng::app {
namespace {

constexpr double frame_ns = 1e9 / 60.0;

// The paper's practical result (3): 40 skeletons of 40 bones, different animations, 6% of a frame at 60 Hz.
constexpr int paper_skeletons = 40;
constexpr int paper_bones = 40;
constexpr double paper_percent = 6.0;

BesideBlocks beside_blocks(const anim::AnimationSystem& system) {
  const anim::UpdateReport& report = system.figures().report();
  std::uint64_t players = 0;
  for (std::uint32_t agent = 0; agent < system.agent_count(); ++agent)
    players += system.agent(agent).program().parts.players;
  return {.bones = static_cast<double>(report.bones_evaluated),
          .stream_bytes = system.figures().stream_bytes(),
          .stream_reads = 2 * players,
          .palette_bytes = report.palette_bytes,
          .palettes = report.agents_updated};
}

/// Runs some frames on one PU and returns the tasks of the fastest, for other work disturbed the slower frames.
std::vector<RecordedTask> fastest_tasks(BenchCrowd& crowd, int frames) {
  std::vector<RecordedTask> fastest;
  double least = std::numeric_limits<double>::max();
  const auto& figures = crowd.system().figures();
  for (int frame = 0; frame < frames; ++frame) {
    crowd.subject.run();
    const anim::UpdateTime& time = figures.update_time();
    if (time.milliseconds >= least) continue;
    least = time.milliseconds;
    fastest = recorded_tasks(figures.units().front().trace().spans(), time, beside_blocks(crowd.system()));
  }
  return fastest;
}

/// One PU, and the first schedule and stream of the options.
anim::SystemOptions one_pu_options(const BenchOptions& options) {
  return bench_system_options(options,
                              {.pus = 1, .schedule = options.schedules.front(), .stream = options.streams.front()});
}

/// One PU with the local store of the machine and a trace of every task.
anim::SystemOptions recorded_options(const BenchOptions& options, const Machine& machine) {
  anim::SystemOptions recorded = one_pu_options(options);
  recorded.local_store_bytes = static_cast<std::size_t>(machine.local_store_kib) * 1024;
  recorded.double_buffering = anim::DoubleBuffering::inline_copy;
  recorded.trace = anim::Tracing::every_task;
  return recorded;
}

bool holds_skeleton(const anim::SystemOptions& options, int bones) {
  auto character = std::make_shared<const anim::Character>(anim::bake_character(anim::synthetic_model(bones, 1)));
  return anim::AnimationSystem::create(std::move(character), options).has_value();
}

/// The most bones of a skeleton of which one character fits; 0: none.
int largest_skeleton(const anim::SystemOptions& options) {
  int fits = 0, too_many = anim::max_bones + 1;
  while (too_many - fits > 1) {
    const int bones = (fits + too_many) / 2;
    (holds_skeleton(options, bones) ? fits : too_many) = bones;
  }
  return fits;
}

/// Forty agents, each with an animation of its own.
std::vector<BenchAgent> paper_agents(const anim::Character& character) {
  std::vector<BenchAgent> agents;
  for (int i = 0; i < paper_skeletons; ++i) {
    const auto clip = static_cast<std::size_t>(i) % character.clips.size();
    agents.push_back({.from_clip = static_cast<int>(clip),
                      .to_clip = BenchAgent::none,
                      .from_start = character.clips[clip].duration * i / paper_skeletons,
                      .to_start = {},
                      .fraction = 0});
  }
  return agents;
}

Status add_paper_case(const BenchOptions& options, const Machine& machine, Json& json) {
  const auto character = std::make_shared<const anim::Character>(
      anim::bake_character(anim::synthetic_model(paper_bones, paper_skeletons)));
  auto there = BenchCrowd::create(character, recorded_options(options, machine), paper_agents(*character));
  if (!there) return there.error();
  const MachinePrediction predicted = predict(machine, fastest_tasks(*there, options.frames));
  auto here = BenchCrowd::create(character, one_pu_options(options), paper_agents(*character));
  if (!here) return here.error();
  BenchRounds rounds;
  rounds.add({"here", [&] { here->subject.run(); }});
  rounds.run(options.frames, "the paper's case: ");
  json["paper_case_reported_percent_of_frame"] = paper_percent;
  json["paper_case_predicted_percent_of_frame"] = 100.0 * predicted.busy_ns / machine.pus / frame_ns;
  json["paper_case_measured_here_percent_of_frame"] = 100.0 * rounds.times().median("here") / frame_ns;
  json["paper_case_measured_here_us"] = rounds.times().median("here") / 1000.0;
  return Done{};
}

}  // namespace

Result<BenchReport> run_machine(const BenchOptions& options, const Machine& machine) {
  const auto character = bench_character(options, options.bones.front(), options.clips.front());
  if (!character) return character.error();

  const anim::SystemOptions recorded = recorded_options(options, machine);
  auto crowd =
      BenchCrowd::create(character->character, recorded, bench_agents(*character->character, options.agents.front()));
  if (!crowd) return crowd.error();
  const std::vector<RecordedTask> tasks = fastest_tasks(*crowd, options.frames);
  const MachinePrediction prediction = predict(machine, tasks);
  anim::CopyCounts copies;
  double recorded_ns = 0;
  for (const RecordedTask& task : tasks) {
    copies += task.before;
    copies += task.while_computing;
    copies += task.after;
    recorded_ns += task.compute_ns;
  }
  const double agents = options.agents.front(), agent_ns = prediction.busy_ns / agents;

  BenchReport report;
  Json& json = report.json;
  json["machine"] = machine.name;
  json["local_store_kib"] = machine.local_store_kib;
  json["pus"] = machine.pus;
  json["schedule"] = schedule_words[static_cast<std::size_t>(options.schedules.front())];
  json["stream"] = stream_words[static_cast<std::size_t>(options.streams.front())];
  json["agents"] = options.agents.front();
  json["bones_per_agent"] = character->character->skeleton.bone_count();
  json["tile"] = crowd->system().figures().schedule().plan.width;
  json["tasks"] = tasks.size();
  json["recorded_compute_ns_per_agent"] = recorded_ns / agents;
  json["dma_bytes_per_agent"] = static_cast<double>(copies.bytes_in + copies.bytes_out) / agents;
  json["dma_transfers_per_agent"] = static_cast<double>(copies.transfers) / agents;
  json["predicted_ns_per_agent"] = agent_ns;
  json["predicted_dma_ns_per_agent"] = prediction.dma_ns / agents;
  json["predicted_stall_percent"] = 100.0 * prediction.stall_ns / prediction.busy_ns;
  json["predicted_overlap_percent"] = 100.0 * prediction.overlap();
  json["largest_skeleton_bones"] = largest_skeleton(recorded);
  json["characters_per_60hz_frame"] = static_cast<std::int64_t>(frame_ns / agent_ns * machine.pus);
  if (const Status added = add_paper_case(options, machine, json); !added) return added.error();
  report.text = figures_as_text(std::span(&json, 1), {});
  return report;
}

}  // namespace throng::app
