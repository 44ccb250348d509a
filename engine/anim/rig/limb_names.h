#pragma once

#include <string_view>
#include <vector>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// The part of a body that the name of a bone says. `leg` and `arm` may be either half of the limb.
enum class BodyPart : unsigned char {
  other,
  helper,  ///< twist and roll bones, IK targets, sockets, leaf ends: never joints of a body
  pelvis,
  spine,
  neck,
  head,
  upper_leg,
  leg,
  lower_leg,
  foot,
  toe,
  shoulder,
  upper_arm,
  arm,
  lower_arm,
  hand,
};

enum class BodySide : unsigned char { none, left, right };

struct LimbName {
  BodyPart part = BodyPart::other;
  BodySide side = BodySide::none;

  friend bool operator==(const LimbName&, const LimbName&) = default;
};

/// Reads the common naming schemes: "mixamorig:LeftUpLeg", "DEF-thigh.L.001", "calf_l", "J_Bip_R_LowerArm", "Bip01 L
/// Foot", "lShin", "upper_arm.L", "LeftKnee".
LimbName read_limb_name(std::string_view bone_name);

/// Returns the part of every bone: as the file or a person says (Bone::role), else as its name says. A part that is
/// said belongs to that bone alone, whatever other bones are called.
std::vector<LimbName> limb_names(const Skeleton& skeleton);

}  // namespace throng::anim
