#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/anim/asset/model.h"
#include "engine/base/json/json.h"
namespace throng::app {

/// One pose of a skeleton.
struct BonePose {
  std::vector<anim::StateTransform> states;  ///< one a bone, relative to the bind pose (see anim::ReferenceFrame)
  std::vector<glm::dmat4> palette;           ///< one a palette entry, model space
};

/// Describes a skin apart from any time: joints, names, mesh nodes.
Json describe_skin(const anim::Model& model, const anim::Skin& skin);

/// Describes the joints and the palette of a skin in one pose. A joint that holds a matrix with shear has no t, r, s.
///
/// `r` is a unit quaternion; it is left out where the rotation keys of `clip` (null: the rest pose) are not unit, since
/// programs then disagree on the rotation, while all agree on `global` and palette.
Json dump_skin(const anim::Model& model, const anim::Skin& skin, const anim::Clip* clip, const BonePose& pose);

}  // namespace throng::app
