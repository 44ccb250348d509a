#include "engine/anim/entity/ragdoll_entity.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include <glm/geometric.hpp>

#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

using Phase = RagdollEntity::Phase;

struct Elapsed {
  Ticks ticks;
};

std::size_t memory_bytes(int bone_count, int components) {
  return sizeof(RagdollMemory) + pose_bytes(bone_count, components);
}

std::span<Handle> source_of_ragdoll(std::byte* block, const EntityLayout&) {
  auto& ragdoll = *reinterpret_cast<RagdollEntity*>(block);
  return {&ragdoll.source, ragdoll.source.valid() ? 1U : 0U};
}

void advance_ragdoll(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& ragdoll = entity.as<RagdollEntity>();
  entity.prepared_as<Elapsed>() = {std::max(ragdoll.state.delta_time, Ticks{})};
  ragdoll.state.delta_time = Ticks{};
  std::ranges::fill(ragdoll.state.linear_velocity, 0.0F);
  std::ranges::fill(ragdoll.state.angular_velocity, 0.0F);
  if (is_loose(ragdoll) || sources.empty()) return;
  std::ranges::copy(sources[0].linear_velocity, ragdoll.state.linear_velocity);
  std::ranges::copy(sources[0].angular_velocity, ragdoll.state.angular_velocity);
}

/// Returns the pose that the first update of letting go kept.
PoseView pose_before(const EntityInStore& entity, int components) {
  auto& memory = entity.private_as<RagdollMemory>();
  return {reinterpret_cast<float*>(&memory + 1), packet_bytes(components) / sizeof(float), components,
          memory.bones_before};
}

void remember(const EntityInStore& entity, const PoseView& pose) {
  entity.private_as<RagdollMemory>().bones_before = pose.bone_count;
  const PoseView before = pose_before(entity, pose.components);
  for (int packet = 0; packet < packets_for(pose.bone_count); ++packet) {
    std::memcpy(before.packet(packet), pose.packet(packet), packet_bytes(pose.components));
  }
}

/// Limits both poses to the bones that both have, so that a change of bone level is no movement.
void take_over(const EntityInStore& entity, const PoseView& pose, Ticks elapsed) {
  const auto& velocity = entity.as<RagdollEntity>().state.linear_velocity;
  PoseView before = pose_before(entity, pose.components);
  PoseView now = pose;
  before.bone_count = now.bone_count = std::min(before.bone_count, now.bone_count);
  ragdoll_from_pose(
      entity.resource_as<RagdollRig>(),
      {.before = before, .now = now, .elapsed = elapsed, .velocity = {velocity[0], velocity[1], velocity[2]}},
      entity.private_as<RagdollMemory>().bodies);
}

int nearest_body(const RagdollRig& rig, const RagdollState& state, const glm::vec3& place) {
  int nearest = 0;
  float least = std::numeric_limits<float>::max();
  for (int body = 0; body < static_cast<int>(rig.bodies.size()); ++body) {
    const float distance = glm::distance(state.bodies[body].position, place);
    if (distance >= least) continue;
    least = distance;
    nearest = body;
  }
  return nearest;
}

void push_if_asked(const EntityInStore& entity) {
  auto& ragdoll = entity.as<RagdollEntity>();
  const auto& rig = entity.resource_as<RagdollRig>();
  const glm::vec3 impulse(ragdoll.impulse[0], ragdoll.impulse[1], ragdoll.impulse[2]);
  const glm::vec3 place(ragdoll.push_place[0], ragdoll.push_place[1], ragdoll.push_place[2]);
  if (impulse == glm::vec3(0.0F)) return;
  RagdollState& bodies = entity.private_as<RagdollMemory>().bodies;
  push_ragdoll(rig, nearest_body(rig, bodies, place), impulse, place, bodies);
  std::ranges::fill(ragdoll.impulse, 0.0F);
}

void fall(const EntityInStore& entity, const PoseView& pose, Ticks elapsed) {
  auto& memory = entity.private_as<RagdollMemory>();
  push_if_asked(entity);
  ragdoll_step(entity.resource_as<RagdollRig>(), {&memory.ground, 1}, elapsed, memory.bodies);
  ragdoll_to_pose(entity.resource_as<RagdollRig>(), memory.bodies, pose);
}

void pose_ragdoll(const EntityInStore& entity, const PoseView& pose) {
  auto& ragdoll = entity.as<RagdollEntity>();
  const Ticks elapsed = entity.prepared_as<Elapsed>().ticks;
  if (ragdoll.phase == Phase::loose) return fall(entity, pose, elapsed);
  if (ragdoll.phase == Phase::first) {
    remember(entity, pose);
    ragdoll.phase = Phase::second;
  } else if (ragdoll.phase == Phase::second && elapsed > Ticks{}) {
    take_over(entity, pose, elapsed);
    ragdoll.phase = Phase::loose;
  }
}

}  // namespace

void let_go(RagdollEntity& ragdoll) {
  if (ragdoll.phase == Phase::animated) ragdoll.phase = Phase::first;
}

EntityKind ragdoll_kind(const RagdollRig& rig) {
  return {.name = "rag-doll",
          .type = EntityType::ragdoll,
          .sources = source_of_ragdoll,
          .private_bytes_for = memory_bytes,
          .keeps_transforms = true,
          .prepared_bytes = 64,
          .reads_identity = false,
          .advance = advance_each<advance_ragdoll>,
          .pose_whole = pose_ragdoll,
          .whole_pose_work = 600,
          .resource = &rig};
}

}  // namespace throng::anim
