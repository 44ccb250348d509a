#include "tests/anim/entity/entity_rig.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/anim/entity/entity_run.h"
#include "engine/anim/run/program/program_table.h"
#include "engine/anim/run/store/pose_entity.h"

namespace throng::anim {

EntityRig::EntityRig(std::span<const ClipStreams> clips)
    : pools_(bones, rigid_components, Residency::resident),
      assets_{.clips = clips,
              .masks = {},
              .selections = {},
              .kernels = &best_kernels(),
              .bone_count = bones,
              .components = rigid_components} {}

Handle EntityRig::create(EntityPools::Kind kind, std::uint32_t owner) {
  const Handle entity = pools_.create(kind);
  pools_.state(entity).owner = owner;
  return entity;
}

Handle EntityRig::held(float radians, float metres) {
  const Handle entity = create(EntityPools::held_states);
  set_pose(entity, radians, metres);
  return entity;
}

void EntityRig::set_pose(Handle held, float radians, float metres) {
  const PoseView view = pose(held);
  for (int bone = 0; bone < bones; ++bone) {
    view.set_rotation(bone, glm::angleAxis(radians, glm::vec3(0.0F, 0.0F, 1.0F)));
    view.set_position(bone, {metres, 0.0F, 0.0F});
  }
}

Handle EntityRig::hold(Handle from, Handle to, float fraction) {
  const Handle entity = create(EntityPools::ease_blenders);
  auto& blender = as<EaseBlender>(entity);
  blender.from = from;
  blender.to = to;
  blender.flags = EaseBlender::held;
  blender.fraction = fraction;
  blender.mask = EaseBlender::no_mask;
  return entity;
}

std::int16_t EntityRig::mask_from(int first) {
  masks_.push_back(allocate_aligned(static_cast<std::size_t>(packets_for(bones) * packet_bones) * sizeof(float)));
  auto* const weights = reinterpret_cast<float*>(masks_.back().get());
  for (int bone = first; bone < bones; ++bone) weights[bone] = 1.0F;
  mask_list_.push_back(weights);
  assets_.masks = mask_list_;
  return static_cast<std::int16_t>(mask_list_.size() - 1);
}

void EntityRig::update(Handle root, Ticks delta, int packets) {
  ProgramTable programs;
  PoseGraph graph;
  const Status compiled = compile_graph(pools_, root, pools_.state(root).owner, programs, graph);
  ASSERT_TRUE(compiled) << compiled.error().message;
  alignas(64) std::array<std::byte, most_prepared_bytes> prepared;
  for (std::size_t i = 0; i < graph.entities.size(); ++i) {
    const PoseStep& step = graph.program->steps[i];
    const EntityInStore entity{.block = pools_.block(graph.entities[i]),
                               .prepared = prepared.data(),
                               .layout = &pools_.layout(graph.entities[i]),
                               .assets = &assets_};
    std::vector<SourceRow> sources;
    std::vector<PoseView> poses;
    for (std::size_t k = 0; k < step.source_count; ++k) {
      const Handle source = graph.entities[step.sources[k]];
      sources.push_back({.first = pools_.block(source), .stride = 0, .shown = nullptr});
      poses.push_back(pose(source));
    }
    entity.as<AnimationStateHeader>().delta_time += delta;
    entity.layout->kind->advance({.first = entity, .sources = sources});
    pose_entity(entity, poses, pose(graph.entities[i]), packets, nullptr);
  }
}

PoseView EntityRig::pose(Handle entity) {
  return {transforms_of(pools_.state(entity)), packet_bytes(rigid_components) / sizeof(float), rigid_components, bones};
}

float EntityRig::angle(Handle entity, int bone) {
  const glm::quat rotation = pose(entity).rotation(bone);
  return 2.0F * std::atan2(rotation.z, rotation.w);
}

float EntityRig::place(Handle entity, int bone) { return pose(entity).position(bone).x; }

std::vector<float> EntityRig::floats(Handle entity) {
  const float* const first = transforms_of(pools_.state(entity));
  return {first, first + pose_bytes(bones, rigid_components) / sizeof(float)};
}

}  // namespace throng::anim
