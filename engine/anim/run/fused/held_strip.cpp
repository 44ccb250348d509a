#include <algorithm>

#include "engine/anim/run/fused/pose_strip.h"
#include "engine/anim/run/store/pose_entity.h"

namespace throng::anim {
namespace {

/// Clears positions of quads that no clip displaces, because the entities of a head read poses as they lie.
void clear_others(std::span<float> packets, std::size_t packet_floats, QuadMask displaced) {
  constexpr std::size_t first_position = std::size_t{4} * packet_bones;
  for (; !packets.empty(); packets = packets.subspan(packet_floats)) {
    for (int quad = 0; quad < packet_quads; ++quad) {
      if (is_in(displaced, quad)) continue;
      float* const x = &packets[first_position + static_cast<std::size_t>(quad * quad_bones)];
      for (int axis = 0; axis < 3; ++axis) std::fill_n(x + axis * packet_bones, quad_bones, 0.0F);
    }
  }
}

/// One packet of all characters.
std::span<float> held_packet(const Strip& strip, int packet) {
  const std::size_t stride = strip.held_stride();
  return strip.scratch->held.subspan(static_cast<std::size_t>(packet) * stride, stride);
}

/// Poses the held packets of a character up to the tail of its program: entity after entity, over clips that are there
/// already.
void compose_head(const Strip& strip, const ComposedRun& run, const PoseView& held, StepCursor cursor) {
  const PoseProgram& program = run.program();
  const std::size_t last = program.tail - std::size_t{1};
  const auto view = [&](float* first) {
    return PoseView{first, strip.context().packet_floats(), held.components, held.bone_count};
  };
  LeftBySteps<PoseView> poses;
  std::array<PoseView, max_sources> source_poses;
  for_each_shared(program, [&](std::size_t i, const PoseStep& step) {
    poses.left[i] = view(const_cast<float*>(transforms_of(strip.tile->shared_state(step.shared))));
  });
  if (run.base != ComposedRun::no_base) poses.left[run.base] = held;
  for_each_own(strip.context(), program, cursor, last + 1,
               [&](std::size_t i, const PoseStep& step, const EntityInStore& entity) {
                 if (!run.poses(i)) return;
                 const FusedScratch& scratch = *strip.scratch;
                 PoseView out = i == last ? held : view(&scratch.registers[step.target * scratch.register_floats]);
                 if (entity.layout->is_resident()) out = view(transforms_of(entity.as<AnimationStateHeader>()));
                 pose_entity(entity, poses.sources(step, source_poses), out, strip.held_packets, nullptr);
                 poses.left[i] = out;
               });
  copy_pose(poses.left[last], held, strip.held_packets);
}

void pose_held_clips(const Strip& strip, const StripPoses& poses, int packet) {
  if (poses.clips().empty()) return;
  const EntityAssets& assets = strip.context().assets;
  const std::span<float> bones = held_packet(strip, packet);
  PoseClipsJob clips = poses.clips().job(assets.components, bones.data());
  clips.packet = packet;
  clips.displaced = quads_of_packet(poses.displaced_quads(), packet);
  assets.kernels->pose_clips(clips);
  if (poses.any_heads()) clear_others(bones, strip.context().packet_floats(), clips.displaced);
}

}  // namespace

void pose_held(const Strip& strip, const StripPoses& poses, StripPalettes& palettes, CopyEngine& engine) {
  for (int packet = 0; packet < strip.held_packets; ++packet) {
    pose_held_clips(strip, poses, packet);
    engine.advance();
  }
  poses.for_each_head([&](const ComposedRun& run, std::size_t character, const StepCursor& cursor) {
    compose_head(strip, run, poses.pose(strip, character), cursor);
  });
  const PoseView first = poses.pose(strip, 0);
  poses.tails().pose_whole(strip, first);
  const std::uint64_t displaced = poses.displaced_quads();
  for (int packet = 0; packet < strip.held_packets; ++packet) {
    poses.tails().pose_packet(strip, first, packet);
    palettes.write({.packet = packet,
                    .local = held_packet(strip, packet).data(),
                    .displaced = quads_of_packet(displaced, packet)});
    engine.advance();
  }
}

}  // namespace throng::anim
