#include "tests/benchmark/programs/frame_recorder.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>

#include "engine/anim/run/store/task_queue.h"
#include "engine/anim/run/tile_cutter.h"
#include "engine/base/tiles.h"

namespace throng::app {
namespace {

using Clock = std::chrono::steady_clock;

double nanoseconds(Clock::duration duration) { return std::chrono::duration<double, std::nano>(duration).count(); }

/// Crowd logic and level of detail read and write about so much of an agent in a frame. It is what their arrays have of
/// one, since nobody counts the bytes of these rounds.
constexpr double crowd_bytes_an_agent = 400;
constexpr int agents_of_a_tile = static_cast<int>(SharedTiles::tile);

/// Shares the bytes of so many agents out over the tasks of rounds that do not pose, by their time.
void add_crowd_bytes(std::span<SimulatedRound> rounds, std::span<const std::uint8_t> poses, int agents) {
  double crowd_ns = 0;
  for (std::size_t i = 0; i < rounds.size(); ++i) crowd_ns += poses[i] != 0 ? 0 : rounds[i].work_ns();
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    if (poses[i] != 0) continue;
    for (SimulatedTask& task : rounds[i].tasks) task.bytes = crowd_bytes_an_agent * agents * task.ns / crowd_ns;
  }
}

/// The tiles that PU 0 posed in the last update of a system, with shares for `pus`.
SimulatedRound posing_round(const anim::AnimationSystem& system, int pus) {
  const anim::Figures figures = system.figures();
  const anim::UpdateTime& time = figures.update_time();
  const anim::UpdateReport& report = figures.report();
  // A palette that is not streamed is read into the cache before it is written.
  const double ways = figures.schedule().stores == anim::StorePolicy::streaming ? 1 : 2;
  const double palette_bytes = ways * static_cast<double>(report.palette_bytes) / std::max(1U, report.agents_updated);
  SimulatedRound round{.tasks = {}, .firsts = {}, .most_at_once = anim::TaskQueue::most_at_once};
  std::vector<int> agents;
  for (const anim::TraceSpan& span : figures.units().front().trace().spans()) {
    if (span.kind != anim::TraceSpan::Kind::compute) continue;
    round.tasks.push_back({.ns = (time.ms(span.end) - time.ms(span.begin)) * 1e6,
                           .bytes = span.bytes_in + span.bytes_out + span.content.agents * palette_bytes});
    agents.push_back(span.content.agents);
  }
  round.firsts.resize(static_cast<std::size_t>(pus) + 1);
  anim::cut_shares(
      static_cast<int>(agents.size()), [&](int task) { return agents[static_cast<std::size_t>(task)]; }, round.firsts);
  return round;
}

}  // namespace

void FrameRecorder::run(int count, Job job) {
  if (!records_ || count <= 0) return threads_.run(count, job);
  Recorded& round = rounds_.emplace_back();
  round.begin = Clock::now();
  Clock::time_point before = round.begin;
  for (int i = 0; i < count; ++i) {
    job.run(job.context, i);
    const Clock::time_point now = Clock::now();
    round.jobs_ns.push_back(nanoseconds(now - before));
    before = now;
  }
  round.end = Clock::now();
}

double FrameRecorder::time(const std::function<void()>& frame) {
  const Clock::time_point start = Clock::now();
  frame();
  return nanoseconds(Clock::now() - start);
}

SimulatedFrame FrameRecorder::record(const std::function<void()>& frame, const anim::AnimationSystem& system) {
  rounds_.clear();
  records_ = true;
  SimulatedFrame result{.serial_ns = time(frame), .rounds = {}};
  records_ = false;
  const anim::UpdateTime& update = system.figures().update_time();
  const auto end = update.start + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double, std::milli>(update.milliseconds));
  const int agents = static_cast<int>(system.agent_count());
  std::vector<std::uint8_t> poses;
  for (const Recorded& round : rounds_) {
    result.serial_ns -= nanoseconds(round.end - round.begin);
    poses.push_back(round.begin >= update.start && round.end <= end ? 1 : 0);
    const int jobs = static_cast<int>(round.jobs_ns.size());
    result.rounds.push_back(poses.back() != 0 ? posing_round(system, jobs) : round_of_jobs(round, agents));
  }
  add_crowd_bytes(result.rounds, poses, agents);
  return result;
}

SimulatedRound FrameRecorder::round_of_jobs(const Recorded& recorded, int agents) {
  constexpr double nearly_all = 0.9;
  const int jobs = std::max(static_cast<int>(recorded.jobs_ns.size()), 1);  // a round of none is not recorded
  const double work = std::accumulate(recorded.jobs_ns.begin(), recorded.jobs_ns.end(), 0.0);
  const bool in_tiles = jobs > 1 && recorded.jobs_ns.front() > nearly_all * work;
  const int count = in_tiles ? std::max((agents + agents_of_a_tile - 1) / agents_of_a_tile, jobs) : jobs;
  SimulatedRound round;
  for (int task = 0; task < count; ++task) {
    round.tasks.push_back({.ns = in_tiles ? work / count : recorded.jobs_ns[static_cast<std::size_t>(task)]});
  }
  for (int job = 0; job <= jobs; ++job) round.firsts.push_back(count * job / jobs);
  return round;
}

}  // namespace throng::app
