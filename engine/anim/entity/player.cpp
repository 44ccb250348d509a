#include "engine/anim/entity/player.h"

#include <algorithm>

#include "engine/anim/asset/data_keys.h"

namespace throng::anim {
namespace {

void wrap(Player& player, FineTicks duration) {
  const FineTicks loops = whole_loops(player.position, duration);
  if (loops == 0) return;
  player.position -= loops * duration;
  player.loop_count += static_cast<std::int32_t>(loops);
  player.flags |= Player::reached_end;
}

void hold_at_end(Player& player, FineTicks duration) {
  const bool at_end = player.speed < 0 ? player.position <= 0 : player.position >= duration;
  player.position = std::clamp(player.position, FineTicks{0}, duration);
  if (at_end) player.flags |= Player::reached_end;
}

void keep_in_clip(Player& player, FineTicks duration) {
  player.flags &= ~Player::reached_end;
  if ((player.flags & Player::looping) != 0 && duration > 0) {
    wrap(player, duration);
  } else {
    hold_at_end(player, duration);
  }
}

RootVelocity velocity_of(const Player& player, const ClipStreams& clip) {
  const bool holds = (player.flags & Player::looping) == 0 && (player.flags & Player::reached_end) != 0;
  if (holds) return {};
  if (clip.root_motion != nullptr) return root_velocity(*clip.root_motion, player.position);
  return {.linear = {clip.linear_velocity[0], clip.linear_velocity[1], clip.linear_velocity[2]}};
}

}  // namespace

void advance_player(Player& player, const ClipStreams& clip) {
  player.position += player.state.delta_time * player.speed;
  player.state.delta_time = 0;
  keep_in_clip(player, clip.duration * fine_ticks_per_tick);
  const RootVelocity velocity = velocity_of(player, clip);
  const double speed = static_cast<double>(player.speed) / 65536.0;
  for (int axis = 0; axis < 3; ++axis) {
    player.state.linear_velocity[axis] = static_cast<float>(velocity.linear[axis] * speed);
    player.state.angular_velocity[axis] = axis == 1 ? static_cast<float>(velocity.yaw * speed) : 0.0F;
  }
}

void seek_player(Player& player, FineTicks position, Ticks duration) {
  player.position = position;
  player.loop_count = 0;
  player.state.delta_time = 0;
  keep_in_clip(player, duration * fine_ticks_per_tick);
  if ((player.flags & Player::looping) != 0) player.flags &= ~Player::reached_end;
}

FineTicks unwrapped_position(const Player& player, Ticks duration) {
  return player.loop_count * duration * fine_ticks_per_tick + player.position;
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

namespace {

void evaluate_packet(const PlayerPose& pose, const Kernels& kernels, int components, int packet, float* out) {
  if (!pose.interpolations.empty()) {
    const auto floats = packet_bytes(components) / sizeof(float);
    evaluate_keyframes(*pose.clip->keyframe, pose.time, pose.interpolations, packet, {out, floats});
  } else {
    kernels.sample({.stream = pose.clip->sampled, .point = pose.point, .packet = packet, .pose = out});
  }
}

}  // namespace

void pose_packet(const PlayerPose& pose, const Kernels& kernels, int components, int packet, float* out) {
  if (pose.bones == nullptr || pose.bones->lanes(packet) != 0) evaluate_packet(pose, kernels, components, packet, out);
  if (pose.bones != nullptr) apply_bone_priorities(*pose.bones, packet, out);
}

}  // namespace throng::anim
