#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/keyframe/keyframe_player.h"
#include "engine/anim/kernel/limb/foot_placement.h"
#include "engine/anim/kernel/limb/look_at.h"

/// What reads or changes the whole pose of one character, or of one limb, each alone: nanoseconds a character.
namespace throng::anim {
namespace {

constexpr int bones = 62;
constexpr float frame_seconds = 1.0F / 60.0F;

/// One character of 62 bones, its rigs, and a pose that is the bind pose before every run.
struct Person {
  Model model = synthetic_model(bones, 1);
  std::shared_ptr<const Character> character = std::make_shared<const Character>(bake_character(model));
  CharacterRigs rigs{model};
  std::size_t packet_floats = packet_bytes(rigid_components) / sizeof(float);
  AlignedBytes memory = allocate_aligned(pose_bytes(bones, rigid_components));

  PoseView bind_pose() {
    PoseView pose{reinterpret_cast<float*>(memory.get()), packet_floats, rigid_components, bones};
    for (int bone = 0; bone < bones; ++bone) {
      pose.set_rotation(bone, {1.0F, 0.0F, 0.0F, 0.0F});
      pose.set_position(bone, glm::vec3(0.0F));
    }
    return pose;
  }
};

/// Hip, knee, ankle and toe of both legs, by the names that the synthetic skeleton gives them.
std::vector<LegBones> legs_of(const Skeleton& skeleton) {
  std::vector<int> bones_by_number(bones, -1);
  for (int bone = 0; bone < bones; ++bone) {
    const std::string& name = skeleton.bones[static_cast<std::size_t>(bone)].name;
    if (name.starts_with("leg_")) bones_by_number[static_cast<std::size_t>(std::stoi(name.substr(4)))] = bone;
  }
  std::erase(bones_by_number, -1);
  std::vector<LegBones> legs;
  for (std::size_t i = 0; i + 3 < bones_by_number.size(); i += 4) {
    legs.push_back({bones_by_number[i], bones_by_number[i + 1], bones_by_number[i + 2], bones_by_number[i + 3]});
  }
  return legs;
}

void report(benchmark::State& state) {
  state.counters["ns_per_character"] =
      benchmark::Counter(1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void report_strip(benchmark::State& state) {
  state.counters["ns_per_character"] = benchmark::Counter(
      widest_strip * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void two_bone_ik(benchmark::State& state) {
  Person person;
  const LegBones leg_bones = legs_of(person.character->skeleton).front();
  const auto leg = make_two_bone_limb(person.character->skeleton, leg_bones.hip, leg_bones.knee, leg_bones.ankle,
                                      {0.0F, 0.0F, 1.0F});
  if (!leg) return state.SkipWithError(leg.error().message.c_str());
  const PoseView pose = person.bind_pose();
  for ([[maybe_unused]] const auto& round : state) {
    const TwoBoneIkJob job{.limb = &*leg, .pose = pose, .target = {0.1F, 0.3F, 0.2F}};
    float missed_by = 0.0F;
    best_kernels().two_bone_ik({&job, 1}, &missed_by);
    benchmark::DoNotOptimize(missed_by);
  }
  report(state);
}
BENCHMARK(two_bone_ik);

void gaze(benchmark::State& state) {
  Person person;
  if (!person.rigs.look_at()) return state.SkipWithError("no head was found");
  LookAtState memory;
  const PoseView pose = person.bind_pose();
  for ([[maybe_unused]] const auto& round : state) {
    const LookAtJob job{.rig = &*person.rigs.look_at(),
                        .state = &memory,
                        .pose = pose,
                        .target = {1.0F, 1.5F, 2.0F},
                        .seconds = frame_seconds};
    best_kernels().look_at({&job, 1});
    benchmark::DoNotOptimize(memory.remaining);
  }
  report(state);
}
BENCHMARK(gaze);

/// Sixteen characters at once, on each target.
void gazes_of_a_strip(benchmark::State& state, const Kernels& kernels) {
  std::vector<Person> people(widest_strip);
  const CharacterRigs& rigs = people.front().rigs;
  if (!rigs.look_at()) return state.SkipWithError("no head was found");
  std::vector<LookAtState> memories(widest_strip);
  std::vector<LookAtJob> jobs;
  for (std::size_t i = 0; i < people.size(); ++i) {
    jobs.push_back({.rig = &*rigs.look_at(),
                    .state = &memories[i],
                    .pose = people[i].bind_pose(),
                    .target = {0.1F * static_cast<float>(i), 1.5F, 2.0F},
                    .seconds = frame_seconds});
  }
  for ([[maybe_unused]] const auto& round : state) kernels.look_at(jobs);
  report_strip(state);
}

void feet_of_a_strip(benchmark::State& state, const Kernels& kernels) {
  std::vector<Person> people(widest_strip);
  const Skeleton& skeleton = people.front().character->skeleton;
  const auto rig = make_foot_placement_rig(skeleton, legs_of(skeleton));
  if (!rig) return state.SkipWithError(rig.error().message.c_str());
  std::vector<PlacedBody> bodies(widest_strip);
  std::vector<PlacedFoot> feet(std::size_t{widest_strip} * max_legs);
  std::vector<FootPlacementJob> jobs;
  for (std::size_t i = 0; i < people.size(); ++i) {
    jobs.push_back({.rig = &*rig,
                    .body = &bodies[i],
                    .feet = &feet[i * max_legs],
                    .pose = people[i].bind_pose(),
                    .seconds = frame_seconds});
    feet[i * max_legs].ground.place.y = -0.01F * static_cast<float>(i);
  }
  for ([[maybe_unused]] const auto& round : state) kernels.place_feet(jobs);
  report_strip(state);
}

void limbs_of_a_strip(benchmark::State& state, const Kernels& kernels) {
  std::vector<Person> people(widest_strip);
  const Skeleton& skeleton = people.front().character->skeleton;
  const LegBones leg = legs_of(skeleton).front();
  const auto limb = make_two_bone_limb(skeleton, leg.hip, leg.knee, leg.ankle, {0.0F, 0.0F, 1.0F});
  if (!limb) return state.SkipWithError(limb.error().message.c_str());
  std::vector<TwoBoneIkJob> jobs;
  for (std::size_t i = 0; i < people.size(); ++i) {
    jobs.push_back(
        {.limb = &*limb, .pose = people[i].bind_pose(), .target = {0.1F, 0.3F + 0.01F * static_cast<float>(i), 0.2F}});
  }
  std::vector<float> missed_by(widest_strip);
  for ([[maybe_unused]] const auto& round : state) kernels.two_bone_ik(jobs, missed_by.data());
  report_strip(state);
}

[[maybe_unused]] const bool registered = [] {
  for (const Kernels& kernels : runnable_kernels()) {
    const std::string target = kernels.target;
    benchmark::RegisterBenchmark(("gazes_of_a_strip/" + target).c_str(), gazes_of_a_strip, kernels);
    benchmark::RegisterBenchmark(("limbs_of_a_strip/" + target).c_str(), limbs_of_a_strip, kernels);
    benchmark::RegisterBenchmark(("feet_of_a_strip/" + target).c_str(), feet_of_a_strip, kernels);
  }
  return true;
}();

void ragdoll(benchmark::State& state) {
  Person person;
  if (!person.rigs.ragdoll()) return state.SkipWithError("nothing was found that could fall");
  const RagdollRig& rig = *person.rigs.ragdoll();
  const PoseView pose = person.bind_pose();
  const GroundPlane ground;
  RagdollState body;
  ragdoll_from_pose(rig, {.before = pose, .now = pose}, body);
  for ([[maybe_unused]] const auto& round : state) {
    wake_ragdoll(body);
    ragdoll_step(rig, {&ground, 1}, ticks_per_second / 60, body);
    ragdoll_to_pose(rig, body, pose);
  }
  report(state);
}
BENCHMARK(ragdoll);

/// A frame of a keyframe player: control keys brought to the time, then every packet.
void keyframe_player(benchmark::State& state) {
  Person person;
  const BakedClip& clip = person.character->clips.front();
  const std::size_t size = interpolation_bytes(bones, rigid_components);
  const AlignedBytes interpolations = allocate_aligned(size);
  const PoseView pose = person.bind_pose();
  KeyframeCursor cursor;
  Ticks time{};
  for ([[maybe_unused]] const auto& round : state) {
    time = (time + ticks_per_second / 60) % clip.duration;
    advance_keyframes(*clip.keyframe(), time, cursor, {interpolations.get(), size});
    for (int packet = 0; packet < packets_for(bones); ++packet) {
      evaluate_keyframes(*clip.keyframe(), time, {interpolations.get(), size}, packet,
                         {pose.packet(packet), person.packet_floats});
    }
  }
  report(state);
}
BENCHMARK(keyframe_player);

void compile_of_a_hierarchy(benchmark::State& state) {
  Person person;
  for ([[maybe_unused]] const auto& round : state) {
    benchmark::DoNotOptimize(compile_hierarchy(person.character->skeleton));
  }
  report(state);
}
BENCHMARK(compile_of_a_hierarchy);

}  // namespace
}  // namespace throng::anim
