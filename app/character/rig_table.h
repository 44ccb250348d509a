#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/files/json_file.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// A person's word for the bone that is a part of the body. `bone` is its key (bone_keys() in bone_lod.h).
struct RigChoice {
  anim::BodyRole role;
  std::string bone;

  friend bool operator==(const RigChoice&, const RigChoice&) = default;
};

/// Reads {"hips": "Bone.003", "leftFoot": "ankle.l"}; the parts have VRM's names. The error names the file and what is
/// wrong in it.
anim::Result<std::vector<RigChoice>> rig_choices_in(const Json& rig, const JsonFile& file);
Json rig_json(std::span<const RigChoice> choices);

/// Gives bones the parts that a person chose, over what the file says. Errors name the part, the bone and the bones
/// that come nearest; then nothing has changed.
anim::Status choose_bones(std::span<const RigChoice> choices, anim::Skeleton& skeleton);

}  // namespace throng::app
