#include "engine/anim/agent/entity_builder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/anim/run/program/pose_program.h"

namespace throng::anim {
namespace {

std::int32_t fixed_point(double speed) { return static_cast<std::int32_t>(std::lround(speed * 65536.0)); }

void place(AnimationStateHeader& state, const AbsoluteRoot& root) {
  state.flags |= AnimationStateHeader::has_absolute_root;
  for (int axis = 0; axis < 3; ++axis) state.absolute_position[axis] = root.position[axis];
  const glm::quat& q = root.rotation;
  std::ranges::copy(std::array{q.x, q.y, q.z, q.w}, state.absolute_rotation);
}

}  // namespace

EntityPools::Kind EntityBuilder::player_kind(std::uint32_t clip) const {
  const bool sampled = about_.stream == StreamKind::sampled && clips_[clip].sampled != nullptr;
  return sampled ? EntityPools::sampled_players : EntityPools::keyframe_players;
}

Handle EntityBuilder::create(EntityPools::Kind kind) const {
  const Handle entity = pools_->create(kind, (about_.owner & shared_owner) != 0);
  pools_->state(entity).owner = about_.owner;
  return entity;
}

Handle EntityBuilder::player(const PlayerStart& start) const {
  const auto clip = static_cast<std::uint32_t>(start.clip);
  const Handle handle = create(player_kind(clip));
  auto& player = as<Player>(handle);
  player.clip = clip;
  player.speed = fixed_point(start.speed);
  player.flags = start.loop ? Player::looping : 0;
  player.bone_selection = start.bone_selection;
  seek(handle, start.start * fine_ticks_per_tick);
  if (start.absolute_root) place(player.state, *start.absolute_root);
  return handle;
}

Handle EntityBuilder::ease(Handle from, Handle to, Ticks total, int mask) const {
  const Handle handle = create(EntityPools::ease_blenders);
  auto& blender = as<EaseBlender>(handle);
  blender.from = from;
  blender.to = to;
  blender.elapsed = lead();
  blender.total = total;
  blender.mask = static_cast<std::int16_t>(mask);
  return handle;
}

Handle EntityBuilder::hold(Handle from, Handle to, float fraction, int mask) const {
  const Handle handle = ease(from, to, Ticks{}, mask);
  auto& blender = as<EaseBlender>(handle);
  blender.flags = EaseBlender::held;
  blender.fraction = fraction;
  return handle;
}

void EntityBuilder::seek(Handle player, FineTicks position) const {
  as<Player>(player).position = position + lead().count() * as<Player>(player).speed;
}

FineTicks EntityBuilder::position(Handle player) const {
  return as<Player>(player).position - lead().count() * as<Player>(player).speed;
}

void EntityBuilder::set_speed(Handle player, double speed) const {
  const FineTicks at = position(player);
  as<Player>(player).speed = fixed_point(speed);
  seek(player, at);
}

}  // namespace throng::anim
