#pragma once

#include <optional>
#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::import {

/// An exactly rigid skeleton, with skins bound to it.
struct RigidCandidate {
  anim::Skeleton skeleton;
  std::vector<anim::Skin> skins;
};

/// Takes the rounding off a general skeleton that is otherwise rigid; returns nothing for any other.
std::optional<RigidCandidate> make_rigid_candidate(const anim::Skeleton& general, const std::vector<anim::Skin>& skins,
                                                   const std::vector<anim::Clip>& clips);

/// Says whether the candidate's palettes agree with the general ones, in the rest pose and at five times of every clip,
/// to half of the tolerance for poses: 1e-4, and 1e-5 of the palette's largest magnitude.
bool shows_the_same(const RigidCandidate& rigid, const anim::Skeleton& general, const std::vector<anim::Skin>& skins,
                    const std::vector<anim::Clip>& clips);

}  // namespace throng::import
