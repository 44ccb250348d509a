#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/anim/agent/agent_motion.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/player.h"

namespace throng::anim {

/// The clip, speed and place with which a player begins.
struct PlayerStart {
  int clip = 0;        ///< index into the character's clips
  double speed = 1.0;  ///< multiple of the clip's own speed; negative: backwards
  Ticks start{};       ///< position in the clip, 0 to its duration
  bool loop = true;
  std::optional<AbsoluteRoot> absolute_root = std::nullopt;  ///< the root of a cut scene
  std::uint32_t bone_selection = Player::every_bone;  ///< the number that `Characters::add_bone_selection` returned
};

// The reasons why a request with such a number is refused.
inline constexpr const char* not_a_speed = "a speed is a number of less than 32,768";
inline constexpr const char* not_a_mask = "mask is not a number that add_mask returned";

inline constexpr const char* not_a_fade = "a fade takes from no time to a day";

/// Returns whether a player can play at this speed.
bool is_speed(double speed);
inline constexpr double slowest_speed = 1.0 / 65536.0;  ///< a slower player stands still
/// Returns whether a fade may last so long, so that the clock can be added to it.
constexpr bool is_fade(Ticks time) { return time >= Ticks{} && time <= 24 * 3600 * ticks_per_second; }

inline constexpr const char* too_many_entities = "at most 1,048,576 entities of a kind live at a time";

/// Makes the entities of channels and post processes, at a frame boundary. An agent's entities may stand ahead of the
/// clock (smooth skipping) or behind it; a new entity stands at the same time.
class EntityBuilder {
 public:
  struct About {
    std::uint32_t owner = 0;  ///< the agent; with the bit shared_owner, all agents may read the entities
    Ticks now{};              ///< the clock
    Ticks posed_at{};         ///< the time at which the agent's entities stand
    StreamKind stream = StreamKind::sampled;
    std::size_t masks = 0;       ///< how many the character has
    std::size_t selections = 0;  ///< how many the character has
  };
  EntityBuilder(EntityPools& pools, std::span<const ClipStreams> clips, const About& about)
      : pools_(&pools), clips_(clips), about_(about) {}

  Ticks now() const { return about_.now; }
  /// Returns a builder for an earlier time of the clock: its entities stand where they would stand if they had been
  /// made then.
  EntityBuilder at(Ticks time) const {
    EntityBuilder earlier = *this;
    earlier.about_.now = time;
    return earlier;
  }
  /// Returns the time from the clock to where the agent's entities stand; negative if they are behind.
  Ticks lead() const { return about_.posed_at - about_.now; }
  const ClipStreams& clip(int index) const { return clips_[static_cast<std::size_t>(index)]; }
  EntityPools& pools() const { return *pools_; }

  // A function below that gets an absent clip, mask or entity reports a misuse, and returns an invalid handle or does
  // nothing. A channel can ask before.
  bool has_clip(int clip) const {
    return clip >= 0 && static_cast<std::size_t>(clip) < clips_.size() && !this->clip(clip).is_empty();
  }
  bool has_mask(int mask) const { return mask >= EaseBlender::no_mask && mask < static_cast<int>(about_.masks); }
  bool has_room() const { return pools_->has_room(); }
  bool has_kind(EntityPools::Kind kind, EntityType type) const {
    return kind < pools_->kind_count() && pools_->layout(kind).kind->type == type;
  }
  /// Returns why a player cannot start like this, in one sentence; null if it can.
  const char* fault_of(const PlayerStart& start) const;

  /// Returns the kind of player that a clip wants under the current stream.
  EntityPools::Kind player_kind(std::uint32_t clip) const;

  /// Makes an entity of any kind, owned by the agent. Its private part is zeroed.
  Handle create(EntityPools::Kind kind) const;
  template <typename Entity>
  Entity& as(Handle entity) const {
    static_assert(sizeof(Entity) <= nowhere_bytes);
    return is_alive(entity) ? pools_->as<Entity>(entity) : *reinterpret_cast<Entity*>(nowhere());
  }
  template <typename Private>
  Private& private_as(Handle entity) const {
    static_assert(sizeof(Private) <= nowhere_bytes);
    return is_alive(entity) ? pools_->private_as<Private>(entity) : *reinterpret_cast<Private*>(nowhere());
  }

  Handle player(const PlayerStart& start) const;
  /// Makes a blender that eases from one state to the other in `total` from now on. `mask` weighs the bones
  /// (EaseBlender::no_mask: all).
  Handle ease(Handle from, Handle to, Ticks total, int mask = EaseBlender::no_mask) const;
  /// Makes a blender that stands still at `fraction`.
  Handle hold(Handle from, Handle to, float fraction, int mask = EaseBlender::no_mask) const;

  // A caller that changes a player several times resolves it once, by as<Player>().

  /// Moves a player so that it is at `position` at the clock.
  void seek(Player& player, FineTicks position) const;
  /// Returns the position of a player at the clock, wherever it stands. It may lie outside of the clip, whole loops
  /// away.
  FineTicks position(const Player& player) const;
  /// Returns how long a player, which does not stand still, takes from one end of its clip to the other.
  Ticks length_of(Handle player) const;
  /// Sets the speed of a player from the clock on. Position and time go on without a jump; a player that holds an end
  /// goes on from there.
  void set_speed(Player& player, double speed) const;

  void destroy(Handle entity) const {
    if (is_alive(entity)) pools_->destroy(entity);
  }

 private:
  static constexpr std::size_t nowhere_bytes = std::size_t{64} << 10U;
  /// Returns whether the entity lives, and reports a misuse if not.
  bool is_alive(Handle entity) const;
  /// Returns zeroed memory that takes writes to an entity that is gone.
  static std::byte* nowhere();

  EntityPools* pools_;
  std::span<const ClipStreams> clips_;
  About about_;
};

}  // namespace throng::anim
