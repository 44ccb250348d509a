#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "app/character/roles.h"
#include "engine/base/result.h"

namespace throng::anim {
class BlendSpace2d;
}

namespace throng::app {

/// The clip that is played alone at a velocity: metres a second at scale 1, x to the left and y ahead.
struct GaitPoint {
  int clip = 0;
  glm::vec2 velocity{0.0F};
  bool is_gait = true;  ///< its feet come down in turns
};

/// Says what a character does in the middle of the plane.
enum class Middle : unsigned char {
  stands,
  steps  ///< on the spot, so that slow people lift their feet; a character without such a clip stands
};

/// Returns the middle, with the velocity 0, and then each of a character's gaits, no two with one velocity. Where side
/// steps or steps back are missing, the shuffle or the walk tramples in their place. A character that cannot walk only
/// stands.
std::vector<GaitPoint> gait_points(const CharacterRoles& roles, Middle middle = Middle::stands);

/// Returns the clip with which a character stands, or the nearest to it.
int standing_clip(const CharacterRoles& roles);

/// Returns gait_points() as a blend space. Errors: a role plays a clip that the character does not have.
Result<std::shared_ptr<const anim::BlendSpace2d>> gait_plane(const CharacterRoles& roles, int clip_count,
                                                             Middle middle = Middle::stands);

}  // namespace throng::app
