#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character/roles.h"
#include "app/crowd/cast.h"
#include "app/crowd/character_look.h"
#include "app/crowd/layout.h"
#include "app/crowd/minds.h"
#include "app/crowd/walkers.h"
#include "app/settings/settings.h"
#include "engine/anim/base/executor.h"
#include "engine/anim/base/units.h"

namespace throng::app {

/// What stays the same about each agent.
struct CrowdLooks {
  std::vector<float> scales;        ///< 0.9 to 1.08
  std::vector<float> radii;         ///< metres
  std::vector<float> paces;         ///< playback of what is done in place; of walkers, speed over that of the clip
  std::vector<float> start_phases;  ///< 0 to below 1
  std::vector<Tints> tints;
  std::vector<Variant> variants;
};

/// All of a crowd that changes as time passes.
struct CrowdMoment {
  anim::Ticks now = 0;
  std::vector<anim::Ticks> behind, next_waves;
  std::optional<CrowdMinds> minds;
  std::optional<CrowdWalkers> walkers;
  std::vector<glm::vec3> positions;
  std::vector<Heading> headings;
  std::vector<float> speeds, playback_speeds;
};

/// Decides who stands, walks, marches or sits where, and what each of them does. All of it follows from scene, agents,
/// seed, the characters' roles and the frames' lengths; no pose is read. Spans have one element an agent, hold the
/// state after the last `advance`, and live as long as the crowd.
class Crowd {
 public:
  /// `characters`: 1 to 256; see CrowdCast for who is which.
  Crowd(Scene scene, std::size_t agents, std::uint32_t seed, std::span<const CharacterRoles> characters);
  Crowd(Scene scene, std::size_t agents, std::uint32_t seed, const CharacterRoles& character)
      : Crowd(scene, agents, seed, std::span(&character, 1)) {}
  Crowd(const Crowd&) = delete;  // its parts point at the cast
  Crowd& operator=(const Crowd&) = delete;

  /// Moves everyone on by `dt` and says who changes clip; the span is valid until the next call. Allocates nothing.
  /// `jobs`, 1 or more, run at once on `executor`; what comes out does not depend on either.
  std::span<const ClipRequest> advance(anim::Ticks dt, anim::Executor& executor, int jobs);
  /// The same in the calling thread.
  std::span<const ClipRequest> advance(anim::Ticks dt);

  /// Where somebody who acts stands now.
  void put(std::uint32_t agent, const glm::vec3& position, const Heading& heading);

  /// Keeps an agent where it is, in the way of all others, and lets it do nothing: it stops walking, which is the
  /// request.
  std::optional<ClipRequest> hold(std::uint32_t agent);
  /// Lets it go on. A marcher catches up with its place in the file.
  std::optional<ClipRequest> release(std::uint32_t agent);
  bool holds(std::uint32_t agent) const { return minds_.holds(agent); }

  /// Keeps all that changes, and puts it back: the crowd goes on as it did then, to the bit. A moment of this very
  /// crowd.
  void remember(CrowdMoment& into) const;
  void go_back_to(const CrowdMoment& moment);

  std::size_t size() const { return positions_.size(); }
  std::span<const glm::vec3> positions() const { return positions_; }  ///< metres, between the feet
  std::span<const Heading> headings() const { return headings_; }
  std::span<const float> scales() const { return looks_.scales; }  ///< 0.9 to 1.08
  std::span<const float> radii() const { return looks_.radii; }    ///< metres, of the body seen from above
  std::span<const float> speeds() const { return speeds_; }        ///< metres a second over the ground
  /// How fast the shown clip is played: of gaits, so that feet do not slide, 0.4 to 1.7; else 0.9 to 1.1. Changes from
  /// frame to frame.
  std::span<const float> playback_speeds() const { return playback_speeds_; }
  std::span<const float> start_phases() const { return looks_.start_phases; }   ///< 0 to below 1, of the first clip
  std::span<const std::uint8_t> characters() const { return cast_.numbers(); }  ///< index among them
  std::span<const Tints> tints() const { return looks_.tints; }
  std::span<const Variant> variants() const { return looks_.variants; }
  std::span<const Role> roles() const { return minds_.roles(); }
  std::span<const Habit> habits() const { return minds_.habits(); }
  std::span<const int> clips() const { return minds_.clips(); }  ///< index, or no_clip for a character that has none

  std::span<const Lane> lanes() const { return walkers_.lanes(); }
  std::size_t walkers() const { return walkers_.count(); }   ///< the first agents: they walk where they like
  std::size_t marchers() const { return marchers_.size(); }  ///< those after them: rank and file; all others stay

 private:
  Crowd(CrowdLayout layout, std::uint32_t seed, std::span<const CharacterRoles> characters);
  void place(const CrowdLayout& layout);
  void expect_wave(const CrowdLayout& layout);
  void lead_wave();
  void follow_walkers();
  void march(anim::Ticks dt);
  double marching_time(std::size_t marcher, anim::Ticks dt);
  void match_playback(std::size_t agent);

  CrowdCast cast_;
  anim::Ticks now_ = 0;
  Lane route_;
  std::vector<MarcherStart> marchers_;
  std::vector<anim::Ticks> behind_;  // by marcher: how late it is at its places
  CrowdMinds minds_;
  CrowdLooks looks_;
  CrowdWalkers walkers_;

  std::vector<glm::vec3> positions_;
  std::vector<Heading> headings_;
  std::vector<float> speeds_, playback_speeds_;

  anim::Ticks wave_period_ = 0;
  std::vector<anim::Ticks> next_waves_;  // by stander: when the wave is there; empty: there is none
};

/// A sphere around all agents' feet.
struct CrowdSphere {
  glm::vec3 centre{0.0F};
  float radius = 0.0F;  ///< metres
};
CrowdSphere bounding_sphere(const Crowd& crowd);

}  // namespace throng::app
