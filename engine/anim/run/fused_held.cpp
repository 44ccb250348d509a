// What held tiles do first: the packets that have to be there before some entity can do its part.

#include <algorithm>

#include "engine/anim/run/fused_characters.h"
#include "engine/anim/run/pose_entity.h"

namespace throng::anim {
namespace {

/// Entities of one kind, each of another character.
struct SideBySide {
  const EntityKind* kind = nullptr;
  std::array<PosedEntity, widest_tile> entities;
  std::size_t count = 0;

  std::span<const PosedEntity> all() const { return std::span(entities).first(count); }
};

void pose_side_by_side(const SideBySide& side, int packets) {
  if (side.kind->pose_tile != nullptr) return side.kind->pose_tile(side.all());
  for (const PosedEntity& each : side.all()) pose_entity(each.entity, {&each.pose, 1}, each.pose, packets, nullptr);
}

}  // namespace

std::size_t FusedTasks::held_stride(const Characters& characters) const {
  return characters.context->packet_floats() * static_cast<std::size_t>(characters.width);
}

PoseView FusedTasks::held_pose(const Characters& characters, std::size_t character) const {
  return {&scratch_.held[character * characters.context->packet_floats()], held_stride(characters),
          characters.context->assets.components, characters.context->bones(characters.work.front().level)};
}

/// The held packets of one character before the tail of its program: entity after entity, over clips that are there
/// already.
void FusedTasks::compose_head(const Characters& characters, Composed& composed) const {
  const PoseProgram& program = *characters.work[composed.character].program;
  const std::size_t last = program.tail - std::size_t{1};
  const PoseView held = held_pose(characters, composed.character);
  const auto view = [&](float* first) {
    return PoseView{first, characters.context->packet_floats(), held.components, held.bone_count};
  };
  LeftBySteps<PoseView> poses;
  std::array<PoseView, max_sources> source_poses;
  for_each_shared(program, [&](std::size_t i, const PoseStep& step) {
    poses.left[i] = view(const_cast<float*>(transforms_of(characters.shared_state(step.shared))));
  });
  if (composed.base != Composed::no_base) poses.left[composed.base] = held;
  for_each_own(*characters.context, program, composed.next, last + 1,
               [&](std::size_t i, const PoseStep& step, const EntityInStore& entity) {
                 if (!composed.poses(i)) return;
                 PoseView out = i == last ? held : view(&scratch_.registers[step.target * scratch_.register_floats]);
                 if (is_resident(*entity.layout)) out = view(transforms_of(entity.as<AnimationStateHeader>()));
                 pose_entity(entity, poses.sources(step, source_poses), out, characters.held_packets, nullptr);
                 poses.left[i] = out;
               });
  copy_pose(poses.left[last], held, characters.held_packets);
}

/// Round by round: of the characters that are not done, all whose next step is of the kind of the first one's.
void FusedTasks::pose_tails(const Characters& characters) {
  for (;;) {
    SideBySide side;
    for (Composed& composed : std::span(composed_).first(composed_count_)) {
      const PoseProgram& program = *characters.work[composed.character].program;
      if (composed.next.step >= program.packet_tail) continue;
      const EntityLayout& layout = program.steps[composed.next.step].layout(*characters.context->pools);
      if (side.kind == nullptr) side.kind = layout.kind;
      if (layout.kind != side.kind) continue;
      side.entities[side.count++] = {composed.next.entity(*characters.context, layout),
                                     held_pose(characters, composed.character)};
      composed.next.pass(layout);
    }
    if (side.kind == nullptr) return;
    pose_side_by_side(side, characters.held_packets);
  }
}

void FusedTasks::compute_held(const Characters& characters, CopyEngine& engine) {
  const EntityAssets& assets = characters.context->assets;
  const std::size_t stride = held_stride(characters);
  const auto held_packet = [&](int packet) { return &scratch_.held[static_cast<std::size_t>(packet) * stride]; };
  for (int packet = 0; packet < characters.held_packets && !clips_.empty(); ++packet) {
    assets.kernels->pose_clips(clips_.job(packet, assets.components, true, held_packet(packet)));
  }
  for (Composed& composed : std::span(composed_).first(composed_count_)) {
    if (!composed.over_clips) compose_head(characters, composed);
    engine.advance();
  }
  for (std::size_t i = composed_count_; i < characters.work.size(); ++i) engine.advance();
  pose_tails(characters);
  for (int packet = 0; packet < characters.held_packets; ++packet) {
    for (const Composed& composed : std::span(composed_).first(composed_count_)) {
      float* const pose = held_pose(characters, composed.character).packet(packet);
      compose_in_place(characters, composed.character, composed.next, packet, pose);
    }
    model_palette_packet(*characters.context, scratch_.model, held_packet(packet), characters.work,
                         {.width = characters.width,
                          .packet = packet,
                          .displaced = is_displaced(characters, packet),
                          .stores = palettes_.policy});
    engine.advance();
  }
}

}  // namespace throng::anim
