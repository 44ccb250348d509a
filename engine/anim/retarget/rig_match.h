#pragma once

#include <string>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::anim {

/// Says which bone of one skeleton follows which of another.
struct RigMatch {
  RigMap from;
  RigMap to;
  std::vector<int> source_of;  ///< by bone of the skeleton that follows: a bone of the other, or -1

  int matched() const;
  bool follows(int source) const;
};

/// Matches the bones of `to` with the bones of `from`: by the parts of the body that both have, then by names. Names
/// are equal after their last colon and whatever their case ("mixamorig:Spine" is "spine"); a name that several bones
/// have matches none.
RigMatch match_rigs(const Skeleton& from, const Skeleton& to);

/// Says whether the keys of a clip of `from` fit `to` as they are: bones that follow have the same parents, and the
/// same rest transforms as far as the clip does not replace them.
bool keys_fit(const Skeleton& from, const Skeleton& to, const RigMatch& match, const Clip& clip);

/// Returns the names of the bones of `from` whose motion is lost: a clip animates them, and no bone follows them or
/// a bone below.
std::vector<std::string> lost_bones(const Skeleton& from, const RigMatch& match, const Clip& clip);

}  // namespace throng::anim
