#include "app/commands/bench/case.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "app/character/source.h"
#include "app/commands/bench/crowd.h"
#include "app/commands/bench/rounds.h"
#include "app/files/byte_hash.h"
#include "app/settings/choices.h"
#include "app/show/figures/statistics.h"
#include "app/show/stage/stage.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::app {
namespace {

constexpr int traced_frames = 10;

bool all_sampled(const anim::Character& character) {
  return std::ranges::all_of(character.clips, [](const anim::BakedClip& clip) { return clip.sampled() != nullptr; });
}

/// The subjects and their data; the order in which they are added is the order within a round.
class CaseBench {
 public:
  /// All refusals come from here, before the first round.
  Status prepare(std::shared_ptr<const anim::Character> character, const anim::SystemOptions& options, int agents);
  const BenchTimes& run(int rounds, const std::string& label) {
    rounds_.run(rounds, label);
    return rounds_.times();
  }
  void trace(TimelineLog& log);
  /// The pose hash covers the timed poses, but their time does not include hashing.
  std::uint64_t hash(int frames) const;
  const anim::AnimationSystem& system() const { return update_->system(); }

 private:
  Result<std::unique_ptr<SystemSubject>> subject(const anim::SystemOptions& options) const;
  void add_write_floors();
  void add_kernels();
  void add_updates();

  std::shared_ptr<const anim::Character> character_;
  anim::SystemOptions options_;
  std::vector<BenchAgent> agents_;
  std::unique_ptr<BenchPalettes> palettes_;
  std::unique_ptr<BenchPalettes> packed_palettes_;  // null: this skeleton's palettes cannot be packed
  // Memory of its own: stores that pass by the caches would empty them of the palettes that the other subjects write.
  std::unique_ptr<BenchPalettes> floor_palettes_;
  std::unique_ptr<SystemSubject> update_, keyframe_;
  std::unique_ptr<KernelSubject> kernels_, packed_kernels_, scalar_;
  BenchRounds rounds_;
};

constexpr std::array<std::pair<const char*, anim::StorePolicy>, 3> store_policies = {
    {{"write plain", anim::StorePolicy::plain},
     {"write prefetched", anim::StorePolicy::prefetched},
     {"write streaming", anim::StorePolicy::streaming}}};

Result<std::unique_ptr<SystemSubject>> CaseBench::subject(const anim::SystemOptions& options) const {
  const bool packed = options.palettes == PaletteFormat::packed && packed_palettes_ != nullptr;
  auto made = SystemSubject::create(character_, options, agents_, packed ? *packed_palettes_ : *palettes_);
  if (!made) return made.error();
  return std::make_unique<SystemSubject>(std::move(*made));
}

void CaseBench::add_write_floors() {
  for (const auto& [key, policy] : store_policies) {
    rounds_.add({key, [this, policy = policy] {
                   anim::best_kernels().write_lines({.lines = floor_palettes_->floats(), .stores = policy});
                   anim::best_kernels().fence_stores();
                 }});
  }
}

void CaseBench::add_kernels() {
  if (!all_sampled(*character_)) return;
  kernels_ = std::make_unique<KernelSubject>(*character_, anim::best_kernels(), agents_, *palettes_);
  scalar_ = std::make_unique<KernelSubject>(*character_, anim::scalar_kernels(), agents_, *palettes_);
  rounds_.add({"scalar", [this] { scalar_->run(); }});
  rounds_.add({"kernels", [this] { kernels_->run(); }});
  if (packed_palettes_ == nullptr) return;
  packed_kernels_ = std::make_unique<KernelSubject>(*character_, anim::best_kernels(), agents_, *packed_palettes_);
  rounds_.add({"packed kernels", [this] { packed_kernels_->run(); }});
}

// One system runs with one PU and with all: two systems differ by a tenth just by where their memory lies.
void CaseBench::add_updates() {
  anim::SystemOptions one_pu = options_;
  one_pu.pus = 1;
  const auto run = [this] { update_->run(); };
  anim::SystemOptions other_stores = one_pu;
  other_stores.stores = system().figures().schedule().stores == anim::StorePolicy::streaming
                            ? anim::StorePolicy::prefetched
                            : anim::StorePolicy::streaming;
  rounds_.add({"other stores", run, [this, other_stores] { update_->configure(other_stores); }});
  rounds_.add({"one pu", run, [this, one_pu] { update_->configure(one_pu); }});
  rounds_.add({"update", run, [this] { update_->configure(options_); }});
  rounds_.add({"untraced", run, [this] { update_->record_trace(anim::Tracing::off); }});
  rounds_.add({"traced", run, [this] { update_->record_trace(anim::Tracing::on); }});
}

Status CaseBench::prepare(std::shared_ptr<const anim::Character> character, const anim::SystemOptions& options,
                          int agents) {
  character_ = std::move(character);
  options_ = options;
  agents_ = bench_agents(*character_, agents);
  const int entries = character_->skeleton.palette_count();
  palettes_ = std::make_unique<BenchPalettes>(agents, entries);
  if (character_->hierarchy.packs()) {
    packed_palettes_ = std::make_unique<BenchPalettes>(agents, entries, PaletteFormat::packed);
  }
  floor_palettes_ = std::make_unique<BenchPalettes>(agents, entries);

  auto update = subject(options);
  if (!update) return update.error();
  update_ = std::move(*update);
  anim::SystemOptions keyframe = options;
  keyframe.stream = anim::StreamKind::keyframe;
  keyframe.local_store_bytes = 0;
  keyframe.tile = 0;
  auto exact = subject(keyframe);
  if (!exact) return exact.error();
  keyframe_ = std::move(*exact);

  // Waiting for memory lets clocks drop for longer than a subject settles, so it goes first: long computing then stands
  // between it and the subjects that are compared.
  add_write_floors();
  rounds_.add({"keyframe", [this] { keyframe_->run(); }});
  add_kernels();
  add_updates();
  return Done{};
}

void CaseBench::trace(TimelineLog& log) {
  update_->configure(options_);
  for (int frame = 0; frame < traced_frames; ++frame) {
    const auto start = TimelineLog::Clock::now();
    update_->run();
    log.add_update(update_->system(), start);
  }
}

std::uint64_t CaseBench::hash(int frames) const {
  anim::SystemOptions hashed = options_;
  hashed.hash = true;
  const auto made = subject(hashed);
  if (!made) return 0;
  for (int frame = 0; frame < frames; ++frame) (*made)->run();
  return (*made)->system().figures().pose_hash();
}

/// The way of writing that took the least time.
std::string write_floor(const BenchTimes& times) {
  const auto median = [&](const auto& store) { return times.median(store.first); };
  return std::ranges::min_element(store_policies, {}, median)->first;
}

void add_figures(Json& json, const BenchTimes& times, double agents, double bones) {
  const auto per_bone = [&](double nanoseconds) { return nanoseconds / agents / bones; };
  const auto per_bone_or_null = [&](const std::string& key) {
    return times.has(key) ? Json(per_bone(times.median(key))) : Json(nullptr);
  };
  const auto ratio_or_null = [&](const std::string& key, const std::string& other) {
    return times.has(key) && times.has(other) ? Json(times.median_ratio(key, other)) : Json(nullptr);
  };
  const std::string floor = write_floor(times);
  json["ns_per_bone_median"] = per_bone(times.median("update"));
  json["ns_per_bone_min"] = per_bone(times.fastest("update"));
  json["write_floor_ns_per_bone_median"] = per_bone(times.median(floor));
  json["scalar_ns_per_bone_median"] = per_bone_or_null("scalar");
  json["keyframe_ns_per_bone_median"] = per_bone(times.median("keyframe"));
  json["kernels_ns_per_bone_median"] = per_bone_or_null("kernels");
  json["packed_kernels_ns_per_bone_median"] = per_bone_or_null("packed kernels");
  json["one_pu_ns_per_bone_median"] = per_bone(times.median("one pu"));
  json["speedup_over_one_pu"] = times.median_ratio("one pu", "update");
  json["kernels_over_write_floor"] = ratio_or_null("kernels", floor);
  json["kernels_over_packed_kernels"] = ratio_or_null("kernels", "packed kernels");
  json["scalar_over_kernels"] = ratio_or_null("scalar", "kernels");
  json["one_pu_over_kernels"] = ratio_or_null("one pu", "kernels");
  json["other_stores_over_one_pu"] = ratio_or_null("other stores", "one pu");
  json["trace_cost_percent"] = 100.0 * (times.median_ratio("traced", "untraced") - 1.0);
  json["agents_per_60hz_frame"] = static_cast<std::int64_t>(agents * (1e9 / 60.0) / times.median("update"));
}

}  // namespace

Result<BenchCharacter> bench_character(const BenchOptions& options, int bones, int clips) {
  const std::string& model = options.model;
  BenchCharacter result;
  if (model.empty()) {
    result.model = anim::synthetic_model(bones, clips);
    result.character = std::make_shared<const anim::Character>(anim::bake_character(result.model));
  } else {
    auto source = load_character(model, model, nullptr, {.import = options.reading});
    if (!source) return source.error();
    result.model = std::move(source->model);
    result.character = std::move(source->character);
  }
  return result;
}

anim::SystemOptions bench_system_options(const BenchOptions& options, const BenchCase& bench) {
  anim::SystemOptions result = options.tuning.system;
  result.pus = bench.pus;
  result.schedule = bench.schedule;
  result.stream = bench.stream;
  result.hash = false;
  return on_this_machine(result);
}

Result<Json> run_bench_case(const BenchOptions& options, const BenchCase& bench, const BenchCharacter& character,
                            const BenchPass& pass, BenchTimes& times, std::optional<TimelineLog>& trace) {
  CaseBench work;
  const Status prepared = work.prepare(character.character, bench_system_options(options, bench), bench.agents);
  if (!prepared) return prepared.error();
  times.append(work.run(pass.rounds, pass.label));
  if (!pass.is_last) return Json(nullptr);
  if (trace) work.trace(*trace);
  const anim::ScheduleOptions& schedule = work.system().figures().schedule();
  const int bones = character.character->skeleton.bone_count();
  Json json;
  json["agents"] = bench.agents;
  json["bones_per_agent"] = bones;
  json["frames"] = options.frames;
  json["pus"] = schedule.pus;
  json["schedule"] = schedule_words[static_cast<std::size_t>(bench.schedule)];
  json["local_store_kib"] = schedule.local_store_bytes / 1024;
  json["tile"] = schedule.plan.width;
  json["stream"] = stream_words[static_cast<std::size_t>(bench.stream)];
  json["palette_format"] = palette_words[static_cast<std::size_t>(work.system().characters().palette_format(0))];
  json["stores"] = schedule.stores == anim::StorePolicy::streaming ? "streaming" : "prefetched";
  json["simd_target"] = work.system().figures().kernels().target;
  json["pose_hash"] = hex_string(work.hash(options.frames));
  json["clips"] = character.character->clips.size();
  add_figures(json, times, bench.agents, bones);
  json["bytes_per_agent"] = work.system().figures().bytes_per_agent();
  json["stream_bytes_per_frame"] = work.system().figures().stream_bytes();
  json["rounds"] = options.frames;
  return json;
}

}  // namespace throng::app
