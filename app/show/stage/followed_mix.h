#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "app/character/roles.h"
#include "app/people/crowd/stride_plane.h"
#include "app/people/crowd/track_steps.h"
#include "app/show/stage/stances.h"
#include "engine/anim/agent/channel/clip_mix_channel.h"
#include "engine/anim/bake/character.h"

namespace throng::app {

/// The moment of a person who follows a track, as far as the pose depends on it.
struct FollowedMoment {
  TrackStep step;
  double seconds = 0.0;      ///< of the file's clock
  double rate = 1.0;         ///< seconds of the file that pass in a second; below 0: backwards
  Ticks ahead{};             ///< time from the animation's clock to the moment
  std::uint32_t person = 0;  ///< people who stand look about at different times
  float speaks = 0.0F;       ///< of standing, the share of talking
};

/// The clips of the pose of such a moment.
struct FollowedMix {
  std::array<anim::MixedClip, anim::ClipMixChannel::most> of{};
  std::size_t count = 0;
  std::array<float, person_legs> planted{};  ///< how firmly each foot stands, 0 to 1

  std::span<const anim::MixedClip> clips() const& { return {of.data(), count}; }
  std::span<const anim::MixedClip> clips() && = delete;  ///< a loop over them would outlive them
};

/// Returns the clips of a moment: gaits by the velocity, all at one place of the stride, and a way to stand, which
/// changes every few seconds. Plane, stances and roles belong to the character. Allocates nothing.
FollowedMix followed_mix(const FollowedMoment& moment, const StridePlane& plane, const Stances& stances,
                         const CharacterRoles& roles, const anim::Character& character);

}  // namespace throng::app
