#pragma once

#include <memory>

#include <glm/vec3.hpp>

#include "app/character/source.h"
#include "engine/anim/bake/character.h"

namespace throng::app {

/// The balloon and the camera of a cut scene, characters of one bone each (paper 2: "animation streams for characters,
/// cameras, animated backgrounds"). `size` is CharacterRoles::size of the actor.

inline constexpr double cut_scene_seconds = 14.0;
inline constexpr double walk_on_seconds = 4.0;  ///< the actor comes to the scene's origin, along +Z
inline constexpr double release_seconds = 4.6;  ///< it lets the balloon go

/// The clips of the balloon: in the hand of an actor at the origin, and up from there.
enum BalloonClip : int { carried, rise };

/// Returns a balloon on a string. Its bone is at the string's end.
CharacterSource balloon(double size);

/// Returns the place of the balloon, `seconds` after the release, in metres from the scene's origin.
glm::dvec3 balloon_place(double seconds, double size);

/// Returns the camera: a bone that looks along -Z, and one clip. It films the actor from the front while it comes, then
/// looks up after the balloon, then down on the crowd.
std::shared_ptr<const anim::Character> film_camera(double size);

}  // namespace throng::app
