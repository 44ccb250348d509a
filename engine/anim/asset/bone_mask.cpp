#include "engine/anim/asset/bone_mask.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/anim/base/pose.h"

namespace throng::anim {

BoneMask::BoneMask(std::string name, const Skeleton& skeleton, std::span<const SubtreeWeight> subtrees, float elsewhere)
    : name_(std::move(name)),
      packets_(packets_for(skeleton.bone_count())),
      weights_(allocate_aligned(static_cast<std::size_t>(packets_ * packet_bones) * sizeof(float))) {
  auto* weights = reinterpret_cast<float*>(weights_.get());
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int parent = skeleton.parent(bone);
    const auto own = std::ranges::find(subtrees, bone, &SubtreeWeight::bone);
    const float inherited = parent < 0 ? elsewhere : weights[parent];
    weights[bone] = own != subtrees.end() ? own->weight : inherited;
    assert(weights[bone] >= 0.0F && weights[bone] <= 1.0F);
  }
}

const float* BoneMask::packet(int index) const {
  assert(index >= 0 && index < packets_);
  return reinterpret_cast<const float*>(weights_.get()) + static_cast<std::ptrdiff_t>(index) * packet_bones;
}

float BoneMask::weight(int bone) const { return packet(bone / packet_bones)[bone % packet_bones]; }

int find_bone(const Skeleton& skeleton, std::string_view name) {
  const auto found = std::ranges::find(skeleton.bones, name, &Bone::name);
  return found == skeleton.bones.end() ? -1 : static_cast<int>(found - skeleton.bones.begin());
}

}  // namespace throng::anim
