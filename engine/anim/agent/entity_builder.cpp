#include "engine/anim/agent/entity_builder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/anim/base/finite.h"
#include "engine/anim/base/misuse.h"
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

constexpr Ticks longest_start = 24 * 3600 * ticks_per_second;

}  // namespace

bool is_speed(double speed) { return std::abs(speed) < 32768.0; }

const char* EntityBuilder::fault_of(const PlayerStart& start) const {
  if (!has_clip(start.clip)) return "clip is not an index of a clip that the character has";
  if (!is_speed(start.speed)) return not_a_speed;
  if (start.start < -longest_start || start.start > longest_start) return "start is within a day of the clip's begin";
  if (start.bone_selection > about_.selections)
    return "bone_selection is not a number that add_bone_selection returned";
  const std::optional<AbsoluteRoot>& root = start.absolute_root;
  if (root && !(all_finite(root->position) && all_finite(root->rotation)))
    return "the absolute root is of finite numbers";
  return nullptr;
}

bool EntityBuilder::is_alive(Handle entity) const {
  if (pools_->alive(entity)) [[likely]]
    return true;
  report_misuse({"EntityBuilder", "a handle names an entity that is gone"});
  return false;
}

std::byte* EntityBuilder::nowhere() {
  alignas(64) static thread_local std::array<std::byte, nowhere_bytes> bytes;
  bytes.fill(std::byte{0});
  return bytes.data();
}

EntityPools::Kind EntityBuilder::player_kind(std::uint32_t clip) const {
  const bool sampled = clips_[clip].played(about_.stream) == StreamKind::sampled;
  return sampled ? EntityPools::sampled_players : EntityPools::keyframe_players;
}

Handle EntityBuilder::create(EntityPools::Kind kind) const {
  if (kind >= pools_->kind_count()) {
    report_misuse({"EntityBuilder::create", "the character has no entities of this kind"});
    return {};
  }
  const Handle entity = pools_->create(kind, (about_.owner & shared_owner) != 0);
  if (!entity.valid()) {
    report_misuse({"EntityBuilder::create", too_many_entities});
    return entity;
  }
  pools_->state(entity).owner = about_.owner;
  return entity;
}

Handle EntityBuilder::player(const PlayerStart& start) const {
  if (const char* fault = fault_of(start); fault != nullptr) {
    report_misuse({"EntityBuilder::player", fault});
    return {};
  }
  const auto clip = static_cast<std::uint32_t>(start.clip);
  const Handle handle = create(player_kind(clip));
  if (!handle.valid()) return handle;
  auto& player = as<Player>(handle);
  player.clip = clip;
  player.speed = fixed_point(start.speed);
  player.flags = start.loop ? Player::looping : 0;
  player.bone_selection = start.bone_selection;
  seek(player, start.start * fine_ticks_per_tick);
  if (start.absolute_root) place(player.state, *start.absolute_root);
  return handle;
}

Handle EntityBuilder::ease(Handle from, Handle to, Ticks total, int mask) const {
  if (!has_mask(mask)) {
    report_misuse({"EntityBuilder::ease", not_a_mask});
    return {};
  }
  const Handle handle = create(EntityPools::ease_blenders);
  if (!handle.valid()) return handle;
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
  if (!handle.valid()) return handle;
  auto& blender = as<EaseBlender>(handle);
  blender.flags = EaseBlender::held;
  blender.fraction = fraction;
  return handle;
}

void EntityBuilder::seek(Player& player, FineTicks position) const {
  player.position = position + distance(lead(), player.speed);
}

FineTicks EntityBuilder::position(const Player& player) const {
  return player.position - distance(lead(), player.speed);
}

Ticks EntityBuilder::length_of(Handle player) const {
  const auto& own = as<Player>(player);
  const FineTicks way = clips_[own.clip].duration * fine_ticks_per_tick;
  const std::int64_t speed = std::max(std::abs(std::int64_t{own.speed}), std::int64_t{1});
  return Ticks{(way + speed - 1) / speed};
}

void EntityBuilder::set_speed(Player& player, double speed) const {
  if (!is_speed(speed)) {
    report_misuse({"EntityBuilder::set_speed", not_a_speed});
    return;
  }
  FineTicks at = position(player);
  const bool looping = (player.flags & Player::looping) != 0;
  if (!looping) at = std::clamp(at, FineTicks{0}, clips_[player.clip].duration * fine_ticks_per_tick);
  player.speed = fixed_point(speed);
  seek(player, at);
}

}  // namespace throng::anim
