#pragma once

#include <string>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/retarget/retarget_plan.h"
#include "engine/anim/retarget/rig_match.h"

namespace throng::anim {

/// A clip that was made for another skeleton.
struct RetargetedClip {
  Clip clip;
  bool as_it_was = false;         ///< its keys fit as they are
  std::vector<std::string> lost;  ///< bones that it animates, and whose motion reaches no bone
};

/// Plays clips of one skeleton on another. Both outlive it.
class Retargeter {
 public:
  Retargeter(const Skeleton& from, const Skeleton& to);

  const RigMatch& match() const { return match_; }
  const RetargetPlan& plan() const { return plan_; }

  /// Returns the clip for the other skeleton. Where both rest alike, keys are copied. Else bones turn through both
  /// reference poses, hips move scaled by leg length, and feet keep their height above the ground; the keys are then
  /// linear, at the clip's own times and at least 30 a second. Its morphs are left out.
  RetargetedClip retarget(const Clip& clip) const;

 private:
  const Skeleton& from_;
  const Skeleton& to_;
  RigMatch match_;
  RetargetPlan plan_;
};

}  // namespace throng::anim
