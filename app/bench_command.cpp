#include "app/bench_command.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/atomic_file.h"
#include "app/bench_crowd.h"
#include "app/exit_status.h"
#include "app/stage.h"
#include "app/statistics.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/import/import.h"

namespace throng::app {
namespace {

constexpr int warm_up_rounds = 2;
constexpr std::chrono::milliseconds settling_time(10);

/// Something that is timed once a round.
struct Subject {
  std::string key;
  std::function<void()> run;
  std::function<void()> prepare = [] {};
  std::vector<double> nanoseconds = {};

  // What ran before has left its mark on caches and clock rates, for some milliseconds: a frame is timed among frames.
  void settle() const {
    const auto start = std::chrono::steady_clock::now();
    do run();
    while (std::chrono::steady_clock::now() - start < settling_time);
  }

  void time() {
    prepare();
    settle();
    const auto start = std::chrono::steady_clock::now();
    run();
    nanoseconds.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
};

// Rewrites its own line, so it is for a person at a terminal only.
void show_progress(int round, int rounds) {
  if (isatty(STDERR_FILENO) == 0) return;
  if (round < rounds) {
    std::fprintf(stderr, "\rround %d of %d ", std::max(round + 1, 0), rounds);
  } else {
    std::fprintf(stderr, "\r%*s\r", 32, "");
  }
}

// Interleaved, so that a drift of the machine's speed meets all subjects alike.
void run_rounds(std::vector<Subject>& subjects, int rounds) {
  for (int round = -warm_up_rounds; round < rounds; ++round) {
    for (Subject& subject : subjects) subject.time();
    if (round < 0) {
      for (Subject& subject : subjects) subject.nanoseconds.clear();
    }
    show_progress(round, rounds);
  }
  show_progress(rounds, rounds);
}

anim::Result<std::shared_ptr<const anim::Character>> bench_character(const BenchOptions& options) {
  if (options.model.empty()) {
    const anim::Model model = anim::synthetic_model(options.bones, options.clips);
    return std::make_shared<const anim::Character>(anim::bake_character(model));
  }
  auto file = import::import_file(options.model);
  if (!file) return file.error();
  return std::make_shared<const anim::Character>(anim::bake_character(file->models.front()));
}

anim::SystemOptions timed_options(const BenchOptions& options) {
  Tuning tuning;
  tuning.pus = options.pus;
  tuning.local_store_kib = options.local_store_kib;
  tuning.tile = options.tile;
  tuning.schedule = options.schedule;
  tuning.double_buffer = options.double_buffer;
  tuning.stream = options.stream;
  anim::SystemOptions result = system_options(tuning);
  result.hash = false;
  return result;
}

bool all_sampled(const anim::Character& character) {
  return std::ranges::all_of(character.clips, [](const anim::BakedClip& clip) { return clip.sampled() != nullptr; });
}

/// The subjects and what they work on; the order of the list is the order within a round.
struct Bench {
  std::shared_ptr<const anim::Character> character;
  std::vector<BenchAgent> agents;
  std::unique_ptr<BenchPalettes> palettes;
  // Memory of its own: stores that pass by the caches would empty them of the palettes that the other subjects write.
  std::unique_ptr<BenchPalettes> floor_palettes;
  std::unique_ptr<SystemSubject> update, keyframe;
  std::unique_ptr<KernelSubject> kernels, scalar;
  std::vector<Subject> subjects;

  double per_bone(double nanoseconds) const {
    return nanoseconds / static_cast<double>(agents.size()) / character->skeleton.bone_count();
  }
  const std::vector<double>& times(const std::string& key) const {
    static const std::vector<double> none;
    const auto found = std::ranges::find(subjects, key, &Subject::key);
    return found == subjects.end() ? none : found->nanoseconds;
  }
};

anim::Result<std::unique_ptr<SystemSubject>> make_subject(const Bench& bench, const anim::SystemOptions& options) {
  auto subject = SystemSubject::create(bench.character, options, bench.agents, *bench.palettes);
  if (!subject) return subject.error();
  return std::make_unique<SystemSubject>(std::move(*subject));
}

void add_kernel_subjects(Bench& bench) {
  if (!all_sampled(*bench.character)) return;
  const anim::Character& character = *bench.character;
  bench.kernels = std::make_unique<KernelSubject>(character, anim::best_kernels(), bench.agents, *bench.palettes);
  bench.scalar = std::make_unique<KernelSubject>(character, anim::scalar_kernels(), bench.agents, *bench.palettes);
  bench.subjects.push_back({"scalar", [&bench] { bench.scalar->run(); }});
  bench.subjects.push_back({"kernels", [&bench] { bench.kernels->run(); }});
}

void add_write_floors(Bench& bench) {
  constexpr std::array<std::pair<const char*, StorePolicy>, 3> policies = {
      {{"write plain", StorePolicy::plain},
       {"write prefetched", StorePolicy::prefetched},
       {"write streaming", StorePolicy::streaming}}};
  for (const auto& [key, policy] : policies) {
    bench.subjects.push_back({key, [&bench, policy = policy] { write_floor(bench.floor_palettes->bytes(), policy); }});
  }
}

/// Everything that can be refused is refused here, before the first round.
anim::Status prepare(Bench& bench, const BenchOptions& options) {
  bench.agents = bench_agents(*bench.character, options.agents);
  const int entries = bench.character->skeleton.palette_count();
  bench.palettes = std::make_unique<BenchPalettes>(options.agents, entries);
  bench.floor_palettes = std::make_unique<BenchPalettes>(options.agents, entries);

  const anim::SystemOptions timed = timed_options(options);
  anim::SystemOptions one_pu = timed;
  one_pu.pus = 1;
  anim::SystemOptions keyframe = timed;
  keyframe.stream = anim::StreamKind::keyframe;
  keyframe.local_store_bytes = 0;
  keyframe.tile = 0;
  auto update = make_subject(bench, timed);
  if (!update) return update.error();
  bench.update = std::move(*update);
  auto exact = make_subject(bench, keyframe);
  if (!exact) return exact.error();
  bench.keyframe = std::move(*exact);
  // What only waits for memory lets clocks drop for longer than a subject settles, so it goes first and long computing
  // stands between it and what is compared.
  add_write_floors(bench);
  bench.subjects.push_back({"keyframe", [&bench] { bench.keyframe->run(); }});
  add_kernel_subjects(bench);
  // One system with one PU and with all: two systems differ by a tenth just by where their memory lies.
  const auto run_update = [&bench] { bench.update->run(); };
  bench.subjects.push_back({"one pu", run_update, [&bench, one_pu] { bench.update->configure(one_pu); }});
  bench.subjects.push_back({"update", run_update, [&bench, timed] { bench.update->configure(timed); }});
  return anim::Done{};
}

/// The pose hash belongs to the poses that were timed, but hashing does not belong into the time.
std::uint64_t hash_of(const Bench& bench, const BenchOptions& options) {
  anim::SystemOptions hashed = timed_options(options);
  hashed.hash = true;
  auto subject = make_subject(bench, hashed);
  if (!subject) return 0;
  for (int frame = 0; frame < options.frames; ++frame) (*subject)->run();
  return (*subject)->system().pose_hash();
}

nlohmann::ordered_json per_bone_or_null(const Bench& bench, const std::vector<double>& times) {
  if (times.empty()) return nullptr;
  return bench.per_bone(median(times));
}

nlohmann::ordered_json report(const Bench& bench, const BenchOptions& options) {
  const anim::AnimationSystem& system = bench.update->system();
  const anim::ScheduleOptions& schedule = system.schedule();
  const double update = median(bench.times("update"));
  const std::vector<double>& updates = bench.times("update");
  const double floor = std::min({median(bench.times("write plain")), median(bench.times("write prefetched")),
                                 median(bench.times("write streaming"))});
  nlohmann::ordered_json json;
  json["agents"] = options.agents;
  json["bones_per_agent"] = bench.character->skeleton.bone_count();
  json["frames"] = options.frames;
  json["pus"] = schedule.pus;
  json["schedule"] = options.schedule == Schedule::fused ? "fused" : "levels";
  json["local_store_kib"] = schedule.local_store_bytes / 1024;
  json["tile"] = schedule.plan.width;
  json["stream"] = options.stream == Stream::sampled ? "sampled" : "keyframe";
  json["simd_target"] = system.kernels().target;
  json["pose_hash"] = hex_string(hash_of(bench, options));
  json["clips"] = bench.character->clips.size();
  json["ns_per_bone_median"] = bench.per_bone(update);
  json["ns_per_bone_min"] = bench.per_bone(*std::ranges::min_element(updates));
  json["write_floor_ns_per_bone_median"] = bench.per_bone(floor);
  json["scalar_ns_per_bone_median"] = per_bone_or_null(bench, bench.times("scalar"));
  json["keyframe_ns_per_bone_median"] = bench.per_bone(median(bench.times("keyframe")));
  json["kernels_ns_per_bone_median"] = per_bone_or_null(bench, bench.times("kernels"));
  json["speedup_over_one_pu"] = median(bench.times("one pu")) / update;
  json["agents_per_60hz_frame"] = static_cast<std::int64_t>(options.agents * (1e9 / 60.0) / update);
  json["bytes_per_agent"] = system.bytes_per_agent();
  json["rounds"] = options.frames;
  return json;
}

}  // namespace

int run_bench(const BenchOptions& options) {
  Bench bench;
  auto character = bench_character(options);
  if (!character) return end_with(exit_job_failed, character.error().message);
  bench.character = std::move(*character);
  const anim::Status prepared = prepare(bench, options);
  if (!prepared) return end_with(exit_usage, prepared.error().message);
  run_rounds(bench.subjects, options.frames);
  const nlohmann::ordered_json json = report(bench, options);
  if (options.json.empty()) {
    for (const auto& [key, value] : json.items()) std::printf("%-34s %s\n", key.c_str(), value.dump().c_str());
    return exit_done;
  }
  const anim::Status written = write_output(options.json, json.dump(2) + "\n");
  return written ? static_cast<int>(exit_done) : end_with(exit_job_failed, written.error().message);
}

}  // namespace throng::app
