// What held tiles do first: the packets that have to be there before some entity can do its part.

#include <algorithm>

#include "engine/anim/run/fused/characters.h"
#include "engine/anim/run/store/pose_entity.h"

namespace throng::anim {
namespace {

/// Positions of quads that no clip displaces, for heads: entities that read poses as they lie.
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

}  // namespace

std::size_t FusedTasks::held_stride(const Characters& characters) const {
  return characters.context->packet_floats() * static_cast<std::size_t>(characters.width);
}

/// Of all characters.
std::span<float> FusedTasks::held_packet(const Characters& characters, int packet) const {
  const std::size_t stride = held_stride(characters);
  return scratch_.held.subspan(static_cast<std::size_t>(packet) * stride, stride);
}

/// The held packets of one character before the tail of its program: entity after entity, over clips that are there
/// already.
void FusedTasks::compose_head(const Characters& characters, const Composed& composed, std::size_t character,
                              StepPlace place) const {
  const PoseProgram& program = *characters.work[character].program;
  const std::size_t last = program.tail - std::size_t{1};
  const PoseView held = pose_of(characters, character);
  const auto view = [&](float* first) {
    return PoseView{first, characters.context->packet_floats(), held.components, held.bone_count};
  };
  LeftBySteps<PoseView> poses;
  std::array<PoseView, max_sources> source_poses;
  for_each_shared(program, [&](std::size_t i, const PoseStep& step) {
    poses.left[i] = view(const_cast<float*>(transforms_of(characters.shared_state(step.shared))));
  });
  if (composed.base != Composed::no_base) poses.left[composed.base] = held;
  for_each_own(*characters.context, program, place, last + 1,
               [&](std::size_t i, const PoseStep& step, const EntityInStore& entity) {
                 if (!composed.poses(i)) return;
                 PoseView out = i == last ? held : view(&scratch_.registers[step.target * scratch_.register_floats]);
                 if (entity.layout->is_resident()) out = view(transforms_of(entity.as<AnimationStateHeader>()));
                 pose_entity(entity, poses.sources(step, source_poses), out, characters.held_packets, nullptr);
                 poses.left[i] = out;
               });
  copy_pose(poses.left[last], held, characters.held_packets);
}

void FusedTasks::pose_held_clips(const Characters& characters, int packet) const {
  if (clips_.empty()) return;
  const EntityAssets& assets = characters.context->assets;
  const std::span<float> poses = held_packet(characters, packet);
  PoseClipsJob clips = clips_.job(assets.components, poses.data());
  clips.packet = packet;
  clips.displaced = quads_of_packet(displaced_quads(), packet);
  assets.kernels->pose_clips(clips);
  if (has_heads()) clear_others(poses, characters.context->packet_floats(), clips.displaced);
}

void FusedTasks::compute_held(const Characters& characters, StripPalettes& palettes, CopyEngine& engine) {
  for (int packet = 0; packet < characters.held_packets; ++packet) {
    pose_held_clips(characters, packet);
    engine.advance();
  }
  for_each_head([&](const Composed& composed, std::size_t character, const StepPlace& place) {
    compose_head(characters, composed, character, place);
  });
  pose_whole_tails(characters);
  const std::uint64_t displaced = displaced_quads();
  for (int packet = 0; packet < characters.held_packets; ++packet) {
    pose_held_tails(characters, packet);
    palettes.write({.packet = packet,
                    .local = held_packet(characters, packet).data(),
                    .displaced = quads_of_packet(displaced, packet)});
    engine.advance();
  }
}

}  // namespace throng::anim
