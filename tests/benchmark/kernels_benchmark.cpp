#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "engine/anim/asset/encode_rows.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/palette/hierarchy.h"

/// The fused pipeline of one PU without anything around it: two samples, one blend, model space and palette, 62 bones,
/// strips of 16 characters, every character at times and a weight of its own. Read ns_per_bone; compare only within one
/// run.
namespace throng::anim {
namespace {

constexpr int bones = 62;
constexpr int packets = packets_for(bones);
constexpr int packet_floats = rigid_components * packet_bones;

struct alignas(64) Line {
  float floats[16];
};
constexpr int palette_lines = static_cast<int>(bones * sizeof(PaletteMatrix) / sizeof(Line)) + 1;
constexpr int packed_lines = (bones + 3) / 4;
using Lines = std::vector<Line>;

Lines floats(int count) { return Lines(static_cast<std::size_t>((count + 15) / 16)); }

/// A packet whose bones have all turned by an angle about x.
Lines unit_pose(float angle) {
  Lines pose = floats(packet_floats);
  std::fill_n(pose[0].floats, packet_bones, std::sin(angle / 2.0F));
  std::fill_n(pose[3].floats, packet_bones, std::cos(angle / 2.0F));
  return pose;
}

/// A trunk of 12 bones, four limbs of 5 and digits of 3 on them.
std::vector<int> parents() {
  std::vector<int> parents(12);
  std::iota(parents.begin(), parents.end(), -1);
  for (int limb = 0; limb < 4; ++limb) {
    const int shoulder = static_cast<int>(parents.size());
    for (int bone = 0; bone < 5; ++bone) parents.push_back(bone == 0 ? 3 + 2 * limb : shoulder + bone - 1);
    const int wrist = static_cast<int>(parents.size()) - 1;
    for (int digit = 0; digit < 3 && static_cast<int>(parents.size()) + 3 <= bones; ++digit) {
      for (int bone = 0; bone < 3; ++bone) {
        parents.push_back(bone == 0 ? wrist : static_cast<int>(parents.size()) - 1);
      }
    }
  }
  while (static_cast<int>(parents.size()) < bones) parents.push_back(11);
  return parents;
}

Skeleton branching_skeleton() {
  Skeleton skeleton;
  for (const int parent : parents()) {
    const auto bone = static_cast<double>(skeleton.bones.size());
    skeleton.bones.push_back({.name = {}, .node = -1, .parent = parent, .rest = {}});
    skeleton.references.push_back({.origin = glm::dvec3(std::sin(bone), bone * 0.02, std::cos(bone))});
    skeleton.palette.push_back({static_cast<int>(bone), glm::dmat4(1.0)});
  }
  skeleton.level_bone_counts = {bones};
  return skeleton;
}

/// A second of a 30 Hz clip in which every bone turns and the root moves.
SampledRows turning_rows(double pace) {
  SampledRows rows;
  rows.bone_count = bones;
  rows.step = ticks_per_second / 30;
  rows.row_count = 31;
  rows.rows.assign(static_cast<std::size_t>(rows.row_count) * packets * packet_floats, 0.0F);
  for (int row = 0; row < rows.row_count; ++row) {
    for (int bone = 0; bone < packets * packet_bones; ++bone) {
      float* lanes = rows.rows.data() + (row * packets + bone / packet_bones) * packet_floats + bone % packet_bones;
      const double half = bone < bones ? 0.4 * std::sin(pace * row * 0.2 + bone) : 0.0;
      lanes[static_cast<std::ptrdiff_t>(bone % 3) * packet_bones] = static_cast<float>(std::sin(half));
      lanes[static_cast<std::ptrdiff_t>(3) * packet_bones] = static_cast<float>(std::cos(half));
      if (bone == 0) lanes[static_cast<std::ptrdiff_t>(5) * packet_bones] = static_cast<float>(0.1 * half);
    }
  }
  return rows;
}

AlignedBytes stream_of(const SampledRows& rows) { return encode_rows(rows, ticks_per_second); }

const SampledStream& as_stream(const AlignedBytes& block) {
  return *reinterpret_cast<const SampledStream*>(block.get());
}

struct Character {
  Ticks first_time;
  Ticks second_time;
  float fraction;
};

/// Everything that the loop reads and writes, made before it.
class Crowd {
 public:
  Crowd(int characters, PaletteFormat format)
      : format_(format),
        program_(compile_hierarchy(branching_skeleton())),
        first_(stream_of(turning_rows(1.0))),
        second_(stream_of(turning_rows(1.7))),
        palettes_(static_cast<std::size_t>(characters * palette_lines)) {
    std::mt19937 random(1);
    for (int i = 0; i < characters; ++i) {
      const auto time = [&] { return Ticks{static_cast<std::int64_t>(random())} % ticks_per_second; };
      characters_.push_back({time(), time(), static_cast<float>(random() % 1000U) * 1e-3F});
    }
  }

  void animate(const Kernels& kernels) {
    for (std::size_t first = 0; first < characters_.size(); first += widest_strip) animate_strip(kernels, first);
  }
  std::size_t size() const { return characters_.size(); }

 private:
  void animate_strip(const Kernels& kernels, std::size_t first) {
    PaletteDestination palettes[widest_strip];
    SamplePoint points[2][widest_strip];
    const int count = static_cast<int>(std::min(characters_.size() - first, std::size_t{widest_strip}));
    for (int lane = 0; lane < count; ++lane) {
      const std::size_t character = first + static_cast<std::size_t>(lane);
      const std::size_t lines = format_ == PaletteFormat::packed ? packed_lines : palette_lines;
      palettes[lane] = PaletteDestination(reinterpret_cast<std::byte*>(palettes_.data() + character * lines));
      points[0][lane] = locate(as_stream(first_), characters_[character].first_time);
      points[1][lane] = locate(as_stream(second_), characters_[character].second_time);
    }
    ModelPaletteJob job;
    job.hierarchy = &program_;
    job.bone_count = bones;
    job.characters = count;
    job.local = local_.front().floats;
    job.carry = carry_.front().floats;
    job.branch_slots = slots_.front().floats;
    job.format = format_;
    job.palettes = palettes;
    for (job.packet = 0; job.packet < packets; ++job.packet) {
      for (int lane = 0; lane < count; ++lane) {
        float* pose = local_.front().floats + lane * packet_floats;
        kernels.sample({&as_stream(first_), points[0][lane], job.packet, pose});
        kernels.sample({&as_stream(second_), points[1][lane], job.packet, other_.front().floats});
        const float fraction = characters_[first + static_cast<std::size_t>(lane)].fraction;
        kernels.blend({pose, other_.front().floats, nullptr, fraction, rigid_components, pose});
      }
      kernels.model_palette(job);
    }
  }

  PaletteFormat format_;
  HierarchyProgram program_;
  AlignedBytes first_, second_;
  std::vector<Character> characters_;
  Lines local_ = floats(widest_strip * packet_floats);
  Lines other_ = floats(packet_floats);
  Lines carry_ = floats(branch_slot_floats * widest_strip);
  Lines slots_ = floats(64 * branch_slot_floats * widest_strip);
  Lines palettes_;
};

void report(benchmark::State& state, std::size_t bones_an_iteration) {
  state.counters["ns_per_bone"] =
      benchmark::Counter(static_cast<double>(bones_an_iteration) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void pipeline(benchmark::State& state, const Kernels& kernels, PaletteFormat format) {
  Crowd crowd(static_cast<int>(state.range(0)), format);
  for ([[maybe_unused]] const auto& round : state) crowd.animate(kernels);
  report(state, crowd.size() * bones);
}

/// One kernel alone over a strip of 16 characters whose data stays in the first cache.
class Workbench {
 public:
  SampleJob sample() {
    return {&as_stream(stream_), locate(as_stream(stream_), ticks_per_second / 7), 1, from_.front().floats};
  }
  BlendJob blend() {
    return {from_.front().floats, to_.front().floats, nullptr, 0.3F, rigid_components, out_.front().floats};
  }
  MixJob mix_of_four(const float* const* bone_weights) {
    return {sources_, shares_, bone_weights, 4, rigid_components, out_.front().floats};
  }
  MixJob mix() { return mix_of_four(nullptr); }
  MixJob masked_mix() { return mix_of_four(masks_); }
  AddJob add() {
    return {from_.front().floats, to_.front().floats, nullptr, 0.3F, rigid_components, out_.front().floats};
  }
  SubtractJob subtract() { return {from_.front().floats, to_.front().floats, rigid_components, out_.front().floats}; }
  OffsetCaptureJob capture_offset() {
    return {from_.front().floats, to_.front().floats,        to_.front().floats, from_.front().floats, 0.016F,
            out_.front().floats,  velocities_.front().floats};
  }
  OffsetApplyJob apply_offset() {
    return {from_.front().floats,      to_.front().floats, velocities_.front().floats,
            offset_decay(0.05F, 0.1F), rigid_components,   out_.front().floats};
  }
  NoiseJob noise() {
    shaken_ = {
        .from = from_.front().floats, .out = from_.front().floats, .moment = &noise_moment_, .bone_weights = nullptr};
    return {.characters = {&shaken_, 1}, .packet = 1, .bone_count = bones};
  }
  /// Two clips for each character of a strip, or as many that show one.
  PoseClipsJob pose_clips(bool blended) {
    for (int lane = 0; lane < widest_strip; ++lane) {
      const Ticks time = ticks_per_second * lane / widest_strip;
      clips_[lane] = {&as_stream(stream_), locate(as_stream(stream_), time)};
      blended_[lane] = {&as_stream(stream_), locate(as_stream(stream_), ticks_per_second - Ticks{1} - time)};
      shown_[lane] = {&clips_[lane], blended ? &blended_[lane] : nullptr, 0.3F};
    }
    return {.characters = shown_, .local = local_.front().floats};
  }
  ModelPaletteJob model_palette() {
    for (int lane = 0; lane < widest_strip; ++lane) {
      destinations_[lane] = PaletteDestination(reinterpret_cast<std::byte*>(palettes_.data() + lane * palette_lines));
    }
    ModelPaletteJob job;
    job.hierarchy = &program_;
    job.bone_count = bones;
    job.local = local_.front().floats;
    job.carry = carry_.front().floats;
    job.branch_slots = slots_.front().floats;
    job.palettes = destinations_;
    return job;
  }

 private:
  NoiseMoment noise_moment_ = noise_moment(1, noise_at(Ticks{12345678}, 3.0F), 0.02F);
  ShakenBones shaken_;
  HierarchyProgram program_ = compile_hierarchy(branching_skeleton());
  AlignedBytes stream_ = stream_of(turning_rows(1.0));
  Lines from_ = unit_pose(0.3F), to_ = unit_pose(0.8F), out_ = floats(packet_floats);
  Lines velocities_ = floats(packet_floats);
  Lines mask_ = unit_pose(0.5F);
  const float* sources_[4] = {from_.front().floats, to_.front().floats, from_.front().floats, to_.front().floats};
  const float* masks_[4] = {mask_.front().floats, nullptr, mask_.front().floats, nullptr};
  float shares_[4] = {0.1F, 0.2F, 0.3F, 0.4F};
  ClipMoment clips_[widest_strip], blended_[widest_strip];
  ShownClips shown_[widest_strip];
  Lines local_ = floats(widest_strip * packet_floats);
  Lines carry_ = floats(branch_slot_floats * widest_strip);
  Lines slots_ = floats(64 * branch_slot_floats * widest_strip);
  Lines palettes_ = floats(widest_strip * palette_lines * 16);
  PaletteDestination destinations_[widest_strip];
};

/// One kernel over one packet of one character.
template <class Job>
void register_alone(const std::string& name, const Kernels& kernels, void (*Kernels::*kernel)(const Job& job),
                    Job (Workbench::*job)()) {
  benchmark::RegisterBenchmark((name + "/" + kernels.target).c_str(), [=, &kernels](benchmark::State& state) {
    Workbench bench;
    const Job work = (bench.*job)();
    for ([[maybe_unused]] const auto& round : state) (kernels.*kernel)(work);
    report(state, packet_bones);
  });
}

void pose_clips_alone(benchmark::State& state, const Kernels& kernels, bool blended) {
  Workbench bench;
  PoseClipsJob job = bench.pose_clips(blended);
  for ([[maybe_unused]] const auto& round : state) {
    for (job.packet = 0; job.packet < packets; ++job.packet) kernels.pose_clips(job);
  }
  report(state, widest_strip * bones);
}

void model_palette_alone(benchmark::State& state, const Kernels& kernels, PaletteFormat format) {
  Workbench bench;
  ModelPaletteJob job = bench.model_palette();
  job.format = format;
  for ([[maybe_unused]] const auto& round : state) {
    for (job.packet = 0; job.packet < packets; ++job.packet) kernels.model_palette(job);
  }
  report(state, widest_strip * bones);
}

/// Writing as many bytes and nothing else: what no kernel can beat.
void write_floor(benchmark::State& state, StorePolicy stores) {
  const auto characters = static_cast<std::size_t>(state.range(0));
  const std::size_t bytes = characters * bones * sizeof(PaletteMatrix);
  const AlignedBytes palettes = allocate_aligned(bytes);
  const WriteLinesJob job{.lines = {reinterpret_cast<float*>(palettes.get()), bytes / sizeof(float)}, .stores = stores};
  for ([[maybe_unused]] const auto& round : state) best_kernels().write_lines(job);
  report(state, characters * bones);
}

void register_all() {
  const auto sizes = [](benchmark::internal::Benchmark* bench) { bench->Arg(16)->Arg(1000)->Arg(10000); };
  for (const Kernels& kernels : runnable_kernels()) {
    const std::string target = kernels.target;
    register_alone("sample", kernels, &Kernels::sample, &Workbench::sample);
    register_alone("blend", kernels, &Kernels::blend, &Workbench::blend);
    register_alone("mix_of_4", kernels, &Kernels::mix, &Workbench::mix);
    register_alone("masked_mix_of_4", kernels, &Kernels::mix, &Workbench::masked_mix);
    register_alone("add", kernels, &Kernels::add, &Workbench::add);
    register_alone("subtract", kernels, &Kernels::subtract, &Workbench::subtract);
    register_alone("capture_offset", kernels, &Kernels::capture_offset, &Workbench::capture_offset);
    register_alone("apply_offset", kernels, &Kernels::apply_offset, &Workbench::apply_offset);
    register_alone("noise", kernels, &Kernels::noise, &Workbench::noise);
    benchmark::RegisterBenchmark(("pose_clips/" + target).c_str(), pose_clips_alone, kernels, false);
    benchmark::RegisterBenchmark(("pose_blended_clips/" + target).c_str(), pose_clips_alone, kernels, true);
    benchmark::RegisterBenchmark(("model_palette/" + target).c_str(), model_palette_alone, kernels,
                                 PaletteFormat::matrices);
    benchmark::RegisterBenchmark(("packed_model_palette/" + target).c_str(), model_palette_alone, kernels,
                                 PaletteFormat::packed);
    sizes(benchmark::RegisterBenchmark(("pipeline/" + target).c_str(), pipeline, kernels, PaletteFormat::matrices));
    sizes(
        benchmark::RegisterBenchmark(("packed_pipeline/" + target).c_str(), pipeline, kernels, PaletteFormat::packed));
  }
  sizes(benchmark::RegisterBenchmark("write_floor/plain", write_floor, StorePolicy::plain));
  sizes(benchmark::RegisterBenchmark("write_floor/prefetched", write_floor, StorePolicy::prefetched));
  sizes(benchmark::RegisterBenchmark("write_floor/streaming", write_floor, StorePolicy::streaming));
}

}  // namespace
}  // namespace throng::anim

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  throng::anim::register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
