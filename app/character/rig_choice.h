#pragma once

#include <string>

#include "engine/anim/asset/body_role.h"

namespace throng::app {

/// A person's choice of the bone that is a part of the body. `bone` is its key (bone_keys() in bone_lod.h).
struct RigChoice {
  anim::BodyRole role;
  std::string bone;

  friend bool operator==(const RigChoice&, const RigChoice&) = default;
};

}  // namespace throng::app
