#include "engine/anim/api/chosen_rig.h"

#include <optional>

#include "engine/anim/asset/body_role.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/base/text/plain_text.h"

namespace throng::detail {

void ChosenRig::give_to(anim::Skeleton& skeleton) {
  for (std::size_t i = 0; i < roles_.size(); ++i) {
    const std::optional<anim::BodyRole> role = anim::body_role_named(roles_[i].role);
    const int chosen = anim::find_bone(skeleton, roles_[i].bone);
    if (!role || chosen < 0) continue;
    for (anim::Bone& bone : skeleton.bones) {
      if (bone.role == role) bone.role.reset();
    }
    skeleton.bones[static_cast<std::size_t>(chosen)].role = role;
    is_found_[i] = true;
  }
}

Status ChosenRig::outcome(const std::string& file) const {
  for (std::size_t i = 0; i < roles_.size(); ++i) {
    if (is_found_[i]) continue;
    const BoneRole& missing = roles_[i];
    const bool is_role = anim::body_role_named(missing.role).has_value();
    const std::string what = is_role ? "no skeleton has a bone named \"" + plain_text(missing.bone) + "\""
                                     : "VRM 1.0 has no part of the body named \"" + plain_text(missing.role) + "\"";
    return Error{plain_text(file) + ": LoadOptions::rig: " + what};
  }
  return Done{};
}

}  // namespace throng::detail
