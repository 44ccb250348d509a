#include "engine/anim/entity/player.h"

namespace throng::anim {
namespace {

constexpr std::size_t prepared_pose_bytes = 64;

// Floor division, so that a player that moves backwards wraps as one that moves forwards does.
FineTicks whole_loops(FineTicks position, FineTicks duration) {
  const FineTicks quotient = position / duration;
  return position % duration < 0 ? quotient - 1 : quotient;
}

void wrap(Player& player, FineTicks duration) {
  const FineTicks loops = whole_loops(player.position, duration);
  if (loops == 0) return;
  player.position -= loops * duration;
  player.loop_count += static_cast<std::int32_t>(loops);
  player.flags |= Player::reached_end;
}

void hold_at_end(Player& player, FineTicks duration) {
  if (player.position >= 0 && player.position < duration) return;
  player.position = player.position < 0 ? 0 : duration;
  player.flags |= Player::reached_end;
}

void advance_entity(const EntityInStore& entity, std::span<const AnimationStateHeader* const>) {
  static_assert(sizeof(PlayerPose) <= prepared_pose_bytes);
  auto& player = entity.as<Player>();
  const ClipStreams& clip = entity.assets->clips[player.clip];
  advance_player(player, clip);
  entity.prepared_as<PlayerPose>() = begin_pose(player, clip, entity.private_part());
}

void pose_sampled_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& pose = entity.prepared_as<PlayerPose>();
  entity.assets->kernels->sample(
      {.stream = pose.clip->sampled, .point = pose.point, .packet = job.packet, .pose = job.out});
}

void pose_keyframe_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& pose = entity.prepared_as<PlayerPose>();
  const auto floats = packet_bytes(entity.assets->components) / sizeof(float);
  evaluate_keyframes(*pose.clip->keyframe, pose.time, pose.interpolations, job.packet, {job.out, floats});
}

}  // namespace

const EntityKind sampled_player_kind = {.name = "sampled player",
                                        .type = EntityType::sampled_player,
                                        .prepared_bytes = prepared_pose_bytes,
                                        .advance = advance_entity,
                                        .pose_packet = pose_sampled_packet};

const EntityKind keyframe_player_kind = {.name = "keyframe player",
                                         .type = EntityType::keyframe_player,
                                         .private_bytes = interpolation_bytes,
                                         .prepared_bytes = prepared_pose_bytes,
                                         .advance = advance_entity,
                                         .pose_packet = pose_keyframe_packet};

void advance_player(Player& player, const ClipStreams& clip) {
  const FineTicks duration = clip.duration * fine_ticks_per_tick;
  player.position += player.state.delta_time * player.speed;
  player.state.delta_time = 0;
  player.flags &= ~Player::reached_end;
  if ((player.flags & Player::looping) != 0 && duration > 0) {
    wrap(player, duration);
  } else {
    hold_at_end(player, duration);
  }
  const float speed = static_cast<float>(player.speed) / 65536.0F;
  for (int axis = 0; axis < 3; ++axis) player.state.linear_velocity[axis] = clip.linear_velocity[axis] * speed;
}

PlayerPose begin_pose(Player& player, const ClipStreams& clip, std::span<std::byte> interpolations) {
  PlayerPose pose{.clip = &clip, .time = player.position / fine_ticks_per_tick, .point = {}, .interpolations = {}};
  if (player.state.type == EntityType::keyframe_player) {
    advance_keyframes(*clip.keyframe, pose.time, player.cursor, interpolations);
    pose.interpolations = interpolations;
  } else {
    pose.point = locate(*clip.sampled, pose.time);
  }
  return pose;
}

}  // namespace throng::anim
