// Predicts frames on more PUs than this machine has: throng_scaling [AGENTS...]. It records frames on one thread and
// simulates machines with them. tests/benchmark/notes_scaling.md tells the results.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "throng/heap_pages.h"

#include "app/commands/bench/case.h"
#include "app/files/exit_status.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/camera/scenes.h"
#include "app/show/figures/statistics.h"
#include "app/show/stage/stage.h"
#include "engine/anim/base/aligned_bytes.h"
#include "engine/base/run_jobs.h"
#include "tests/benchmark/programs/bench_crowd.h"
#include "tests/benchmark/programs/frame_recorder.h"
#include "tests/benchmark/programs/many_pus.h"

namespace throng::app {
namespace {

constexpr const char* character_file = THRONG_SOURCE_DIR "/assets/mannequin.glb";
constexpr int pus_here = 2;
constexpr int rounds = 9, frames_of_a_round = 3;
constexpr int most_recorded = 500'000;  // agents; each plays two clips, and a system has room for a million players
constexpr Ticks step = ticks_per_second / 60;

/// A crowd whose frames are recorded.
class Subject {
 public:
  Subject() = default;
  virtual ~Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  virtual void use_pus(int pus) = 0;
  virtual void frame() = 0;
  virtual const anim::AnimationSystem& system() const = 0;
};

anim::SystemOptions recorded_options(anim::SystemOptions options, FrameRecorder& recorder) {
  options.hash = false;
  options.executor = &recorder;
  options.trace = anim::Tracing::every_task;
  return options;
}

/// Everybody of `throng bench`: two clips each, no crowd logic, no level of detail.
class BenchSubject final : public Subject {
 public:
  BenchSubject(int agents, FrameRecorder& recorder) {
    const BenchOptions bench;
    character_ = bench_character(bench, bench.bones.front(), bench.clips.front())->character;
    options_ = recorded_options(bench_system_options(bench, {.pus = 1}), recorder);
    crowd_.emplace(std::move(*BenchCrowd::create(character_, options_, bench_agents(*character_, agents))));
  }
  void use_pus(int pus) override {
    options_.pus = pus;
    crowd_->subject.configure(options_);
  }
  void frame() override { crowd_->subject.run(); }
  const anim::AnimationSystem& system() const override { return crowd_->system(); }

 private:
  std::shared_ptr<const anim::Character> character_;
  anim::SystemOptions options_;
  std::optional<BenchCrowd> crowd_;
};

/// The plaza as the demo shows it: crowd logic, level of detail, and the poses of those who are due.
class PlazaSubject final : public Subject {
 public:
  PlazaSubject(int agents, FrameRecorder& recorder) {
    tuning_.scene = Scene::plaza;
    tuning_.agents = agents;
    tuning_.system = recorded_options(tuning_.system, recorder);
    tuning_.system.pus = 1;
    std::vector<CharacterSource> characters;
    characters.push_back(std::move(*load_character(character_file, "mannequin")));
    stage_ = std::move(*Stage::create(std::move(characters), tuning_, pages_));
    const auto cameras = scene_cameras(Scene::plaza, stage_->crowd().size(), stage_->characters()[0].roles);
    camera_ = camera_at(cameras.front().place);
  }
  void use_pus(int pus) override {
    tuning_.system.pus = pus;
    static_cast<void>(stage_->apply(tuning_));
  }
  void frame() override {
    stage_->move(step);
    stage_->pose(camera_, width, height, step, frame_++);
  }
  const anim::AnimationSystem& system() const override { return stage_->system(); }

 private:
  static constexpr int width = 1280, height = 720;

  Tuning tuning_;
  HeapPageSource pages_{std::size_t{16} << 20U};
  std::unique_ptr<Stage> stage_;
  render::Camera camera_;
  std::uint64_t frame_ = 0;
};

/// The bytes that PUs copy in a nanosecond, read and written, all at once.
double memory_rate(FrameRecorder& recorder, int pus) {
  constexpr std::size_t bytes = std::size_t{256} << 20U;
  std::vector<anim::AlignedBytes> from, to;
  for (int pu = 0; pu < pus; ++pu) {
    from.push_back(anim::allocate_aligned(bytes));
    to.push_back(anim::allocate_aligned(bytes));
    std::memset(from.back().get(), 1, bytes);
    std::memset(to.back().get(), 1, bytes);
  }
  std::vector<double> rates;
  for (int round = 0; round < rounds; ++round) {
    const double ns = recorder.time([&] {
      run_jobs(recorder, static_cast<std::size_t>(pus),
               [&](std::size_t pu) { std::memcpy(to[pu].get(), from[pu].get(), bytes); });
    });
    rates.push_back(2.0 * static_cast<double>(bytes) * pus / ns);
  }
  return median(std::move(rates));
}

/// The nanoseconds from the start of an empty round to its end, frame after frame.
double empty_round_ns(FrameRecorder& recorder) {
  std::vector<double> times;
  for (int i = 0; i < 1000; ++i) {
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::microseconds(20)) {
    }
    times.push_back(recorder.time([&] { run_jobs(recorder, pus_here, [](std::size_t) {}); }));
  }
  return median(std::move(times));
}

SimulatedFrame median_frame(Subject& subject, FrameRecorder& recorder, int pus) {
  subject.use_pus(pus);
  std::vector<SimulatedFrame> frames;
  for (int i = 0; i < rounds + 2; ++i) {
    SimulatedFrame frame = recorder.record([&] { subject.frame(); }, subject.system());
    if (i >= 2) frames.push_back(std::move(frame));  // the first ones fill caches
  }
  const auto middle = frames.begin() + rounds / 2;
  std::nth_element(frames.begin(), middle, frames.end(), [](const SimulatedFrame& a, const SimulatedFrame& b) {
    return a.serial_ns + a.work_ns() < b.serial_ns + b.work_ns();
  });
  return *middle;
}

/// Holds the simulation of this machine against what it does.
void check_here(Subject& subject, FrameRecorder& recorder, const ManyPus& here) {
  std::vector<double> one, two, predicted, off;
  const auto timed = [&](int pus) {
    subject.use_pus(pus);
    std::vector<double> times;
    for (int i = 0; i < frames_of_a_round + 2; ++i) {
      const double ns = recorder.time([&] { subject.frame(); });
      if (i >= 2) times.push_back(ns);
    }
    return median(std::move(times));
  };
  for (int round = 0; round < rounds; ++round) {
    one.push_back(timed(1));
    two.push_back(timed(pus_here));
    std::vector<double> simulated;
    for (int i = 0; i < frames_of_a_round + 2; ++i) {
      const SimulatedFrame frame = recorder.record([&] { subject.frame(); }, subject.system());
      if (i >= 2) simulated.push_back(simulate(here, frame).ns());
    }
    predicted.push_back(median(std::move(simulated)));
    off.push_back(predicted.back() / two.back());
  }
  std::printf("  measured here: one PU %.2f ms, two %.2f ms; two simulated %.2f ms, %.2f of measured\n",
              median(one) / 1e6, median(two) / 1e6, median(predicted) / 1e6, median(off));
}

void simulate_machines(Subject& subject, FrameRecorder& recorder, std::span<const ManyPus> machines, int times) {
  const SimulatedFrame alone = repeated(median_frame(subject, recorder, 1), times);
  const double one_ns = alone.serial_ns + alone.work_ns();
  std::printf("  one PU: %.2f ms, of which %.2f ms are for PU 0 alone\n", one_ns / 1e6, alone.serial_ns / 1e6);
  std::printf("  %-32s %5s %9s %7s %8s %8s %8s %8s\n", "machine", "PUs", "frame ms", "times", "serial", "work", "queue",
              "memory");
  for (const ManyPus& machine : machines) {
    const FrameTime time = simulate(machine, repeated(median_frame(subject, recorder, machine.pus), times));
    std::printf("  %-32s %5d %9.3f %7.1f %8.3f %8.3f %8.3f %8.3f\n", machine.name.c_str(), machine.pus, time.ns() / 1e6,
                one_ns / time.ns(), time.serial_ns / 1e6, time.work_ns / 1e6, time.queue_ns / 1e6,
                time.memory_ns / 1e6);
  }
}

/// Machines that one can buy. Rates are four fifths of what their memory is sold with, which is what programs see;
/// lines are between cores that share no cache but the last.
std::vector<ManyPus> machines(const ManyPus& here) {
  const double desktop = 0.8 * 96, server = 0.8 * 460, link = 0.8 * 192;
  std::vector<ManyPus> all = {here};
  const auto add = [&](const ManyPus& machine) {
    all.push_back(machine);
    all.back().wake_ns = here.wake_ns;
  };
  add({.name = "desktop, 2 x DDR5-6000", .pus = 8, .memory_gigabytes_per_second = desktop, .line_ns = 60});
  add({.name = "desktop, 2 x DDR5-6000", .pus = 16, .memory_gigabytes_per_second = desktop, .line_ns = 60});
  add({.name = "server, 12 x DDR5-4800", .pus = 16, .memory_gigabytes_per_second = server, .line_ns = 100});
  add({.name = "server, 12 x DDR5-4800", .pus = 64, .memory_gigabytes_per_second = server, .line_ns = 100});
  ManyPus two{.name = "two of them, data near PUs",
              .pus = 128,
              .sockets = 2,
              .memory_gigabytes_per_second = server,
              .link_gigabytes_per_second = link,
              .line_ns = 150};
  add(two);
  two.name = "two of them, data on the first";
  two.on_first_socket = true;
  add(two);
  return all;
}

void look_at(const char* name, Subject& subject, FrameRecorder& recorder, const ManyPus& here, int times) {
  std::printf("%s, %d agents\n", name, times * static_cast<int>(subject.system().agent_count()));
  if (times > 1) std::printf("  the frame of %u agents, %d times\n", subject.system().agent_count(), times);
  for (int i = 0; i < 30; ++i) subject.frame();
  check_here(subject, recorder, here);
  simulate_machines(subject, recorder, machines(here), times);
  std::fflush(stdout);
}

int run(std::span<const int> crowds) {
  FrameRecorder recorder(pus_here);
  const ManyPus here{.name = "here",
                     .pus = pus_here,
                     .memory_gigabytes_per_second = memory_rate(recorder, pus_here),
                     .wake_ns = empty_round_ns(recorder) / 2,
                     .line_ns = 60};
  std::printf("here: one PU copies %.1f GB/s, two %.1f GB/s; an empty round takes %.2f us\n", memory_rate(recorder, 1),
              here.memory_gigabytes_per_second, 2 * here.wake_ns / 1000);
  for (const int agents : crowds) {
    const int times = (agents + most_recorded - 1) / most_recorded;
    {
      BenchSubject posing(agents / times, recorder);
      look_at("posing alone", posing, recorder, here, times);
    }
    PlazaSubject plaza(agents / times, recorder);
    look_at("plaza", plaza, recorder, here, times);
  }
  return exit_done;
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  std::vector<int> crowds;
  for (int i = 1; i < argument_count; ++i) {
    crowds.push_back(std::atoi(arguments[i]));
    if (crowds.back() > 0) continue;
    return throng::app::end_with(throng::app::exit_usage,
                                 std::string(arguments[i]) + ": give numbers of agents, each 1 or more");
  }
  if (crowds.empty()) crowds = {10'000, 1'000'000};
  return throng::app::run(crowds);
}
