#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character/source.h"
#include "app/people/crowd/crowd.h"
#include "app/show/stage/followed_mix.h"
#include "engine/anim/agent/animation_system.h"

namespace throng::app {

/// Returns the gaits of a character in the plane of its velocity, and how it stands.
StridePlane stride_plane_of(const CharacterSource& source);

/// Returns the recorded crowd with the gaits of these characters; null `trajectories` are for no scene of them.
TrackSource track_source(std::shared_ptr<const Trajectories> trajectories, std::span<const CharacterSource> characters);

/// Poses people who follow the tracks of a recorded crowd. Each agent plays a mix of gaits that follows from the time
/// of the crowd's clock alone, and is set only where the agent is posed.
class TrackPlayers {
 public:
  /// Gives every agent its channel. All arguments outlive this; `characters` has one element a character of the system.
  TrackPlayers(anim::AnimationSystem& system, const Crowd& crowd, std::span<const CharacterSource> characters);

  /// Sets what an agent plays when it is posed `ahead` of the clock. Call it before its update. Allocates nothing.
  void set(std::uint32_t agent, Ticks ahead);
  /// Returns how firmly the feet of an agent stand in the moment that was set last, 0 to 1 each.
  std::span<const float> planted(std::uint32_t agent) const { return planted_[agent]; }
  /// Returns how firmly the feet of an agent stand at any time of the file's clock.
  std::array<float, person_legs> planted_at(std::uint32_t agent, double seconds) const;

  /// The place that an agent looks at, in its model space, and the share of the way that its head turns there.
  struct Gaze {
    glm::vec3 target;
    float share;
  };
  /// Returns where an agent that talks to another looks now; nothing for all other agents.
  std::optional<Gaze> gaze(std::uint32_t agent) const;

 private:
  FollowedMix mix_of(std::uint32_t agent, double seconds, Ticks ahead) const;

  anim::AnimationSystem* system_;
  const Crowd* crowd_;
  std::span<const CharacterSource> characters_;
  std::vector<Stances> stances_;                         // [character]
  std::vector<std::array<float, person_legs>> planted_;  // [agent]
};

}  // namespace throng::app
