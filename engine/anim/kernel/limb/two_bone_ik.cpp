#include "engine/anim/kernel/limb/two_bone_ik.h"

#include <algorithm>
#include <string>

#include <glm/geometric.hpp>

#include "engine/anim/kernel/lanes/rotations.h"

namespace throng::anim {

Result<TwoBoneLimb> make_two_bone_limb(const Skeleton& skeleton, int upper, int middle, int end,
                                       const glm::vec3& bend_direction) {
  Result<JointChain> chain = make_joint_chain(skeleton, end);
  if (!chain) return chain.error();
  TwoBoneLimb limb{.chain = *chain, .upper = chain->find(upper), .middle = chain->find(middle)};
  const std::string name = skeleton.bones[static_cast<std::size_t>(end)].name;
  if (limb.upper < 0 || limb.middle <= limb.upper || limb.end() <= limb.middle) {
    return Error{"bones " + std::to_string(upper) + ", " + std::to_string(middle) + " and " + std::to_string(end) +
                 " of skeleton '" + skeleton.name + "' are not one below the other, so they are no limb ending at '" +
                 name + "'"};
  }
  const auto origin = [&](int bone) { return skeleton.references[static_cast<std::size_t>(bone)].origin; };
  const glm::vec3 first(origin(middle) - origin(upper));
  const glm::vec3 second(origin(end) - origin(middle));
  if (glm::length(first) < shortest_limb_bone || glm::length(second) < shortest_limb_bone) {
    return Error{"the limb of skeleton '" + skeleton.name + "' that ends at bone '" + name +
                 "' has two joints at the same place: choose joints that are apart"};
  }
  const glm::vec3 direction = glm::normalize(first);
  const glm::vec3 bent_as_asked =
      unit_or_perpendicular(glm::cross(perpendicular_part(bend_direction, direction), direction), direction);
  limb.hinge = bend_normal(direction, glm::normalize(second), bent_as_asked);
  return limb;
}

glm::vec3 bend_normal(const glm::vec3& first, const glm::vec3& second, const glm::vec3& hinge) {
  const glm::vec3 crossed = glm::cross(first, second);
  const float sine = glm::length(crossed);
  const float bent = std::clamp((sine - straight_below) / (bent_above - straight_below), 0.0F, 1.0F);
  return unit_or(unit_or(crossed, hinge) * bent + hinge * (1.0F - bent), hinge);
}

}  // namespace throng::anim
