#pragma once

#include <optional>
#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::import {

/// A skeleton made exactly rigid, with its skins bound to it.
struct RigidCandidate {
  anim::Skeleton skeleton;
  std::vector<anim::Skin> skins;
};

/// Takes the rounding off a skeleton on the general path that is rigid but for it; nothing where it is not.
std::optional<RigidCandidate> make_rigid_candidate(const anim::Skeleton& general, const std::vector<anim::Skin>& skins,
                                                   const std::vector<anim::Clip>& clips);

/// Whether the candidate's palettes agree with the general ones, in the rest pose and at five times of every clip, to
/// half of the tolerance that poses are held to: 1e-4 and 1e-5 of the palette's largest magnitude.
bool shows_the_same(const RigidCandidate& rigid, const anim::Skeleton& general, const std::vector<anim::Skin>& skins,
                    const std::vector<anim::Clip>& clips);

}  // namespace throng::import
