#include <cstring>

#include "engine/anim/run/fused/pose_strip.h"

namespace throng::anim {
namespace {

/// Poses one packet of a character up to the tail of its program: entity after entity, over clips that are there
/// already.
void compose_packet(const Strip& strip, const ComposedRun& run, std::size_t character, StepCursor cursor, int packet) {
  const PoseProgram& program = run.program();
  const std::size_t floats = strip.context().packet_floats();
  const std::size_t offset = static_cast<std::size_t>(packet) * floats;
  float* const local = strip.pose(character);
  LeftBySteps<const float*> poses;
  std::array<const float*, max_sources> sources;
  const std::size_t last = program.tail - std::size_t{1};
  for_each_shared(program, [&](std::size_t i, const PoseStep& step) {
    poses.left[i] = transforms_of(strip.tile->shared_state(step.shared)) + offset;
  });
  if (run.base != ComposedRun::no_base) poses.left[run.base] = local;
  for_each_own(strip.context(), program, cursor, last + 1,
               [&](std::size_t i, const PoseStep& step, const EntityInStore& entity) {
                 if (!run.poses(i)) return;
                 const EntityKind& kind = *entity.layout->kind;
                 if (kind.whole_pose()) {
                   poses.left[i] = poses.left[step.sources[0]];  // all its bones lie in held packets
                   return;
                 }
                 float* out = i == last ? local : &strip.scratch->registers[step.target * floats];
                 if (entity.layout->is_resident()) out = transforms_of(entity.as<AnimationStateHeader>()) + offset;
                 kind.pose_packet(entity,
                                  {.packet = packet, .sources = poses.sources(step, sources).data(), .out = out});
                 poses.left[i] = out;
               });
  if (poses.left[last] != local) std::memcpy(local, poses.left[last], floats * sizeof(float));
}

void compose_packets(const Strip& strip, const StripPoses& poses, int packet) {
  poses.for_each_head([&](const ComposedRun& run, std::size_t character, const StepCursor& cursor) {
    compose_packet(strip, run, character, cursor, packet);
  });
  poses.tails().pose_packet(strip, poses.pose(strip, 0), packet);
}

}  // namespace

// Data that all packets need is looked up before the first: kernels leave nothing else in L1.
void pose_streaming(const Strip& strip, const StripPoses& poses, StripPalettes& palettes, CopyEngine& engine) {
  const EntityAssets& assets = strip.context().assets;
  const auto pose_clips = assets.kernels->pose_clips;
  const bool shows_clips = !poses.clips().empty(), composes = poses.any_composed();
  const std::uint64_t displaced = poses.displaced_quads();
  float* const local = strip.scratch->model.local.data();
  PoseClipsJob clips = poses.clips().job(assets.components, local);
  const int packets = strip.packets;
  for (int packet = strip.held_packets; packet < packets; ++packet) {
    if (!composes && !palettes.needs(packet)) {  // clips are posed alike later; entities may remember a packet
      engine.advance();
      continue;
    }
    clips.packet = packet;
    clips.displaced = quads_of_packet(displaced, packet);
    if (shows_clips) pose_clips(clips);
    if (composes) compose_packets(strip, poses, packet);
    palettes.write({.packet = packet, .local = local, .displaced = clips.displaced});
    engine.advance();
  }
}

}  // namespace throng::anim
