#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>

#include "engine/anim/agent/channel.h"
#include "engine/anim/asset/marker_map.h"

namespace throng::anim {

/// A point of a blend space that plays now.
struct PlayingPoint {
  std::size_t point = 0;  ///< its number in the blend space
  int clip = 0;
  float weight = 1.0F;  ///< above 0
  bool is_gait = true;  ///< it keeps step with the other gaits; else it plays at its own rate
};

/// The points of a blend space that play at a time, and the pace of their gaits.
struct PlayingPoints {
  static constexpr std::size_t most = 3;

  std::array<PlayingPoint, most> of{};  ///< their weights add up to 1
  std::size_t count = 0;                ///< at least 1
  double cycles_per_second = 0.0;       ///< that all gaits make

  std::span<const PlayingPoint> all() const& { return {of.data(), count}; }
  std::span<const PlayingPoint> all() && = delete;  ///< a loop over them would outlive them
  std::array<float, most> weights() const { return {of[0].weight, of[1].weight, of[2].weight}; }
};

/// Sums up the strides of the gaits that play, from which their common pace follows.
struct StrideSum {
  static constexpr double least = 1e-6;  ///< metres a cycle: clips that go less far set no pace

  double weight = 0.0;
  double cycles = 0.0;          ///< weight * cycles a second of the clips as they were made
  double metres_a_cycle = 0.0;  ///< weight * metres

  /// `speed`: metres a second at which the clip was made.
  void add(const EntityBuilder& build, const PlayingPoint& gait, double speed);
  /// Returns the mean pace of the clips; 0 without any.
  double own_cycles_per_second() const { return weight > 0.0 ? cycles / weight : 0.0; }
};

/// Plays some clips at a time and blends them: by an ease blender for two, by a mixer for more. It is a part of
/// channels.
class BlendedPlayers {
 public:
  static constexpr std::size_t most = 5;

  /// A clip, and the key by which it is known from one call to the next.
  struct Wanted {
    std::size_t key = 0;
    int clip = 0;
  };

  /// Plays 1 to `most` clips, no key twice. A player stays as long as its key is wanted. Returns whether any player
  /// changed, or has another place.
  bool take(const EntityBuilder& build, std::span<const Wanted> wanted);
  /// Blends the players, by one weight each. Of two weights, which add up to 1, it reads the second. Returns whether
  /// another entity blends them.
  bool blend(const EntityBuilder& build, std::span<const float> weights);
  /// Sets the weights alone, after a call of blend() for the same players.
  void weigh(const EntityBuilder& build, std::span<const float> weights) const;

  Handle player(std::size_t place) const { return players_[place]; }
  /// Returns the entity whose pose is the blend.
  Handle state() const { return blend_.valid() ? blend_ : players_[0]; }
  void visit_handles(const std::function<void(Handle&)>& visit);
  void destroy_entities(const EntityBuilder& build);

 private:
  std::array<Handle, most> players_;
  std::array<std::size_t, most> keys_{};
  std::size_t count_ = 0;
  Handle blend_;  // an ease blender of two, or a mixer of more; invalid where one plays alone
};

/// Plays and blends the clips of up to three points of a blend space.
///
/// Gaits keep step. The heaviest leads at an even pace. Each of the others is placed where its own markers, the data
/// keys that it shares with the leader, come at the same time as the leader's (asset/marker_map.h). A leader stays
/// until another gait is heavier, and hands its place in the stride over. Clips that are no gaits play at their own
/// rate and keep their place as long as they have a weight.
class InStepPlayers {
 public:
  static constexpr std::size_t most = PlayingPoints::most;

  /// Plays these points from the clock on. Returns whether state(), or an entity that it reads, is another than before.
  bool play(const EntityBuilder& build, const PlayingPoints& points);

  /// Does what play() does if exactly these points play already, in this order; else does nothing, and returns false.
  /// Makes and destroys no entity.
  bool play_on(const EntityBuilder& build, const PlayingPoints& points);

  Handle state() const { return players_.state(); }
  /// Returns the phase of the leader at the clock, 0 to below 1; 0 where no gait plays.
  double phase(const EntityBuilder& build) const;
  /// Returns when the players must be put in step again: where a foot of the leader comes down, or after ten seconds,
  /// because speeds are rounded to 1/65536.
  Ticks next_update() const { return next_update_; }
  void visit_handles(const std::function<void(Handle&)>& visit) { players_.visit_handles(visit); }
  void destroy_entities(const EntityBuilder& build) {
    players_.destroy_entities(build);
    *this = {};
  }

 private:
  static constexpr std::size_t no_player = most;

  /// A place in the stride of a clip.
  struct Stride {
    int clip = -1;           ///< -1: no gait plays
    FineTicks position = 0;  ///< 0 to below the clip's duration
  };
  /// How a follower is led until a foot comes down. It is kept, since markers are slow to match.
  struct Step {
    int leader = -1;  ///< the clip of the leader; -1: none was matched
    int clip = -1;    ///< of the follower
    MarkerMap::Way way;
  };
  /// The players of points_. They are resolved once a call.
  using Players = std::array<Player*, most>;
  Players players(const EntityBuilder& build) const;
  Stride stride(const EntityBuilder& build, const Players& players) const;
  bool take_players(const EntityBuilder& build, std::span<const PlayingPoint> points);
  std::size_t choose_leader() const;
  void keep_step(const EntityBuilder& build, const Players& players, const Stride& before, double cycles_per_second);
  void lead(const EntityBuilder& build, Player& leader, const Stride& before, double cycles_per_second) const;
  void follow(const EntityBuilder& build, const Players& players, std::size_t place, const Stride& leader);

  BlendedPlayers players_;  // of points_
  std::array<PlayingPoint, most> points_{};
  std::array<Step, most> steps_{};  // of points_ that follow
  std::size_t count_ = 0;
  std::size_t leader_ = no_player;
  Ticks next_update_ = never;
};

}  // namespace throng::anim
