#include "engine/anim/entity/player.h"

#include <cstring>
#include <new>

#include "engine/anim/asset/data_keys.h"
#include "engine/anim/entity/entity_run.h"
#include "engine/base/compiler.h"

namespace throng::anim {
namespace {

void wrap(Player& player, FineTicks duration) {
  if (player.position >= 0 && player.position < duration)
    return;  // most players stay in their clip, and a division is slow
  const bool in_next_loop = player.position >= duration && player.position - duration < duration;
  const FineTicks loops = in_next_loop ? 1 : whole_loops(player.position, duration);
  if (loops == 0) return;
  player.position -= loops * duration;
  // Without a sign, because it may pass the end of 32 bits after years.
  player.loop_count =
      static_cast<std::int32_t>(static_cast<std::uint32_t>(player.loop_count) + static_cast<std::uint32_t>(loops));
  player.flags |= Player::reached_end;
}

/// The position goes on beyond an end, so that a player that was posed ahead of the clock knows when it got there. It
/// stops an hour beyond, before 64 bits are full.
void hold_at_end(Player& player, FineTicks duration) {
  constexpr FineTicks beyond = 3600 * ticks_per_second * fine_ticks_per_tick;
  const bool at_end = player.speed < 0 ? player.position <= 0 : player.position >= duration;
  player.position = std::clamp(player.position, -beyond, duration + beyond);
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

bool stands_still(const Player& player, const ClipStreams& clip) {
  const bool holds = (player.flags & Player::looping) == 0 && (player.flags & Player::reached_end) != 0;
  return holds || clip.root_motion == nullptr;
}

void set_velocity(AnimationStateHeader& state, const RootVelocity& velocity, double speed) {
  for (int axis = 0; axis < 3; ++axis) {
    state.linear_velocity[axis] = static_cast<float>(velocity.linear[axis] * speed);
    state.angular_velocity[axis] = axis == 1 ? static_cast<float>(velocity.yaw * speed) : 0.0F;
  }
}

/// Resets the parts of a state that every update changes: its delta time and its velocities.
void clear_motion(AnimationStateHeader& state) {
  constexpr std::size_t bytes = sizeof(state) - identity_bytes;
  std::memset(reinterpret_cast<std::byte*>(&state) + identity_bytes, 0, bytes);
}

/// Returns true in the usual case: the player loops, did not wrap in the last update, and has no root motion.
bool only_moves(const Player& player, const ClipStreams& clip) {
  return (player.flags & (Player::looping | Player::reached_end)) == Player::looping && clip.root_motion == nullptr;
}

// Inline, since this is the frame's innermost loop, where a call takes as long as its body.
inline void move_player(Player& player, const ClipStreams& clip) {
  const FineTicks duration = clip.duration * fine_ticks_per_tick;
  const FineTicks position = player.position + distance(player.state.delta_time, player.speed);
  player.position = position;
  clear_motion(player.state);
  const bool is_inside = static_cast<std::uint64_t>(position) < static_cast<std::uint64_t>(duration);
  if (is_inside && only_moves(player, clip)) [[likely]]
    return;
  keep_in_clip(player, duration);
  if (stands_still(player, clip)) return;
  set_velocity(player.state, root_velocity(*clip.root_motion, position_in_clip(player, clip.duration)),
               static_cast<double>(player.speed) / 65536.0);
}

}  // namespace

void advance_player(Player& player, const ClipStreams& clip) { move_player(player, clip); }

FineTicks position_in_clip(const Player& player, Ticks duration) {
  return std::clamp(player.position, FineTicks{0}, duration * fine_ticks_per_tick);
}

namespace {

/// The values that packets are made from (2.2.3, second half of the update). A player of a SampledStream keeps only its
/// position in the block.
struct SampledPose {
  ClipMoment moment;
  const BoneSelection* bones;  ///< null: every bone; packets without any are not evaluated
};

/// A player of a KeyframeStream advances its interpolation structures once, before its first packet.
struct KeyframePose {
  const KeyframeStream* stream;
  Ticks time;
  std::span<std::byte> interpolations;
  const BoneSelection* bones;
};

constexpr std::size_t prepared_pose_bytes = 64;
static_assert(sizeof(SampledPose) <= prepared_pose_bytes && sizeof(KeyframePose) <= prepared_pose_bytes);

/// Returns the time in the clip, which is not negative.
Ticks time_of(const Player& player, const ClipStreams& clip) {
  const auto position = static_cast<std::uint64_t>(position_in_clip(player, clip.duration));
  return Ticks{static_cast<std::int64_t>(position / std::uint64_t{fine_ticks_per_tick.count()})};
}

/// Prefetches both rows, which are neighbours (paper 2.2.3, note 5). Packets are sampled one by one, so most of a row
/// has time to arrive.
void prefetch_rows(const SampledStream& stream, const SamplePoint& point) {
  constexpr std::ptrdiff_t line = 64;
  const std::byte* const end = point.to + stream.row_stride;
  for (const std::byte* at = point.from; at < end; at += line) prefetch(at);
}

const BoneSelection* selection_of(const Player& player, const EntityAssets& assets) {
  if (player.bone_selection == Player::every_bone) [[likely]]
    return nullptr;
  return &assets.selections[player.bone_selection - 1];
}

void advance_sampled(const EntityInStore& entity, const SourcesInStore&) {
  auto& player = entity.as<Player>();
  const ClipStreams& clip = entity.assets->clips[player.clip];
  move_player(player, clip);
  // Constructed in place, since a copy waits for the parts that were just written.
  ::new (entity.prepared)
      SampledPose{.moment = {.stream = clip.sampled, .point = locate(*clip.sampled, time_of(player, clip))},
                  .bones = selection_of(player, *entity.assets)};
}

void advance_keyframed(const EntityInStore& entity, const SourcesInStore&) {
  auto& player = entity.as<Player>();
  const ClipStreams& clip = entity.assets->clips[player.clip];
  move_player(player, clip);
  const auto& pose = *::new (entity.prepared) KeyframePose{.stream = clip.keyframe,
                                                           .time = time_of(player, clip),
                                                           .interpolations = entity.private_part(),
                                                           .bones = selection_of(player, *entity.assets)};
  advance_keyframes(*pose.stream, pose.time, player.cursor, pose.interpolations);
}

ShownClips clip_of_player(const EntityInStore& entity, const SourcesInStore&) {
  const auto& pose = entity.prepared_as<SampledPose>();
  return {.clip = pose.bones == nullptr ? &pose.moment : nullptr};
}

/// Prefetches after the loop that moves the players, which hints would slow down.
void advance_sampled_players(const EntityRun& run) {
  advance_each<advance_sampled, clip_of_player>(run);
  if (!run.first.assets->prefetch) return;
  for (std::size_t i = 0; i < run.count; ++i) {
    const ClipMoment& moment = run.entity(i).prepared_as<SampledPose>().moment;
    prefetch_rows(*moment.stream, moment.point);
  }
}

/// Skips packets without a selected bone.
template <typename Evaluate>
void pose_selected(const BoneSelection* bones, const PacketJob& job, Evaluate&& evaluate) {
  if (bones == nullptr) return evaluate();
  if (bones->lanes(job.packet) != 0) evaluate();
  apply_bone_priorities(*bones, job.packet, job.out);
}

void pose_sampled_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& pose = entity.prepared_as<SampledPose>();
  pose_selected(pose.bones, job, [&] {
    entity.assets->kernels->sample(
        {.stream = pose.moment.stream, .point = pose.moment.point, .packet = job.packet, .pose = job.out});
  });
}

void pose_keyframe_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& pose = entity.prepared_as<KeyframePose>();
  const std::size_t floats = packet_bytes(entity.assets->components) / sizeof(float);
  pose_selected(pose.bones, job, [&] {
    evaluate_keyframes(*pose.stream, pose.time, pose.interpolations, job.packet, {job.out, floats});
  });
}

}  // namespace

const EntityKind sampled_player_kind = {.name = "sampled player",
                                        .type = EntityType::sampled_player,
                                        .prepared_bytes = prepared_pose_bytes,
                                        .reads_identity = false,
                                        .final_once_advanced = true,
                                        .advance = advance_sampled_players,
                                        .pose_packet = pose_sampled_packet};

const EntityKind keyframe_player_kind = {.name = "keyframe player",
                                         .type = EntityType::keyframe_player,
                                         .private_bytes_for = interpolation_bytes,
                                         .prepared_bytes = prepared_pose_bytes,
                                         .reads_identity = false,
                                         .advance = advance_each<advance_keyframed>,
                                         .pose_packet = pose_keyframe_packet};

}  // namespace throng::anim
