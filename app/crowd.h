#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character_look.h"
#include "app/crowd_lanes.h"
#include "app/crowd_layout.h"
#include "app/crowd_roles.h"
#include "app/settings.h"
#include "engine/anim/base/units.h"

namespace throng::app {

/// An agent changes what it does: ease from the clip it plays now into `clip`.
struct ClipRequest {
  std::uint32_t agent;
  Role role;
  int clip;            ///< index among the character's clips
  float fade_seconds;  ///< of the crowd's clock
};

struct StandingClip {
  Role role;
  int clip;
};

/// Who stands or walks where. All of it follows from scene, agents, seed and the character's roles; no pose is read.
/// Spans have one element an agent, hold the state after the last `advance`, and live as long as the crowd.
class Crowd {
 public:
  Crowd(Scene scene, std::size_t agents, std::uint32_t seed, const CharacterRoles& roles);

  /// Moves the walkers on by `dt` and says who changes clip; the span is valid until the next call. Allocates nothing.
  std::span<const ClipRequest> advance(anim::Ticks dt);

  std::size_t size() const { return positions_.size(); }
  std::span<const glm::vec3> positions() const { return positions_; }  ///< metres, between the feet
  std::span<const Heading> headings() const { return headings_; }
  std::span<const float> scales() const { return scales_; }                    ///< 0.9 to 1.08
  std::span<const float> playback_speeds() const { return playback_speeds_; }  ///< 0.9 to 1.1
  std::span<const float> start_phases() const { return start_phases_; }        ///< 0 to below 1, of the first clip
  std::span<const Tints> tints() const { return tints_; }
  std::span<const Role> roles() const { return roles_; }
  std::span<const int> clips() const { return clips_; }  ///< index, or no_clip for a character that has none

  std::span<const Lane> lanes() const { return lanes_; }
  std::size_t walkers() const { return walkers_.size(); }  ///< the first agents; all others stand

 private:
  void give_looks(std::uint32_t seed);
  void give_first_clips(std::uint32_t seed);
  StandingClip first_standing_clip(std::size_t agent);
  StandingClip next_standing_clip(std::size_t agent);
  void change_clip(std::size_t agent);
  void move_walkers();

  CharacterRoles character_;
  std::vector<StandingClip> standing_clips_;  // what standing agents take turns in; idle, if there, is the first
  anim::Ticks now_ = 0;

  std::vector<Lane> lanes_;
  std::vector<WalkerStart> walkers_;

  std::vector<glm::vec3> positions_;
  std::vector<Heading> headings_;
  std::vector<float> scales_, playback_speeds_, start_phases_;
  std::vector<Tints> tints_;
  std::vector<Role> roles_;
  std::vector<int> clips_;
  std::vector<anim::Ticks> next_changes_;
  std::vector<Random> whims_;  // each agent's own chance
  std::vector<ClipRequest> requests_;
};

/// A sphere around all agents' feet.
struct CrowdSphere {
  glm::vec3 centre{0.0F};
  float radius = 0.0F;  ///< metres
};
CrowdSphere bounding_sphere(const Crowd& crowd);

}  // namespace throng::app
