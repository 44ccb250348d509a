#include "engine/anim/rig/limb_shapes.h"

#include <algorithm>
#include <cstddef>

#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {

namespace {

constexpr float alike = 0.05F;        // of the height: mirrored joints may be off by this
constexpr float feet_within = 0.15F;  // of the height: feet are no further above the lowest joint
constexpr float apart = 0.01F;        // of the height: nearer joints are in the same place

/// Returns the chain of bones from `bone` to its end, or none if it forks.
std::vector<int> unforked_chain(const JointMap& joints, int bone) {
  std::vector<int> chain{bone};
  while (joints.children[static_cast<std::size_t>(chain.back())].size() == 1) {
    chain.push_back(joints.children[static_cast<std::size_t>(chain.back())].front());
  }
  const bool is_limb = joints.children[static_cast<std::size_t>(chain.back())].empty();
  return is_limb ? chain : std::vector<int>();
}

/// Says whether all pairs of joints are at the same height, and apart along one level line.
bool mirror_each_other(const JointMap& joints, const std::vector<int>& a, const std::vector<int>& b) {
  if (a.size() != b.size()) return false;
  const float tolerance = alike * joints.height;
  const glm::vec3 between = joints.level(b.front(), a.front());
  if (glm::length(between) < apart * joints.height) return false;
  const glm::vec3 across = glm::normalize(between);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::vec3 gap = joints.at(a[i]) - joints.at(b[i]);
    const float along = glm::dot(gap, across);
    if (along <= 0.0F || glm::length(gap - across * along) > tolerance) return false;
  }
  return true;
}

template <typename Accept>
std::optional<LimbPair> only_pair(const JointMap& joints, Accept accept) {
  std::optional<LimbPair> found;
  for (const std::vector<int>& siblings : joints.children) {
    for (std::size_t i = 0; i < siblings.size(); ++i) {
      for (std::size_t j = i + 1; j < siblings.size(); ++j) {
        const std::vector<int> a = unforked_chain(joints, siblings[i]);
        const std::vector<int> b = unforked_chain(joints, siblings[j]);
        if (a.size() < 3 || !mirror_each_other(joints, a, b) || !accept(a)) continue;
        if (found) return std::nullopt;
        const auto limb = [](const std::vector<int>& chain) {
          return LimbBones{chain[0], chain[1], chain[2], chain.size() > 3 ? chain[3] : -1};
        };
        found = LimbPair(limb(a), limb(b));
      }
    }
  }
  return found;
}

}  // namespace

JointMap::JointMap(const Skeleton& of) : skeleton(of), children(of.bones.size()) {
  const ReferencePose rest = skeleton.rigid ? ReferencePose{} : reference_pose(skeleton, nullptr, 0.0);
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const int parent = skeleton.bones[b].parent;
    if (parent >= 0) children[static_cast<std::size_t>(parent)].push_back(static_cast<int>(b));
    places.emplace_back(skeleton.rigid ? skeleton.references[b].origin : glm::dvec3(rest.globals[b][3]));
  }
  const auto [low, high] = std::ranges::minmax_element(places, {}, &glm::vec3::y);
  lowest = low->y;
  height = high->y - low->y;
}

glm::vec3 JointMap::level(int from, int to) const {
  const glm::vec3 way = at(to) - at(from);
  return {way.x, 0.0F, way.z};
}

std::optional<LimbPair> find_leg_shapes(const JointMap& joints) {
  return only_pair(joints, [&](const std::vector<int>& chain) {
    if (chain.size() > 4) return false;
    const float foot = joints.at(chain[2]).y;
    const bool hangs = joints.at(chain[0]).y - foot > 0.25F * joints.height;
    return hangs && foot - joints.lowest < feet_within * joints.height;
  });
}

std::optional<LimbPair> find_arm_shapes(const JointMap& joints, const LimbPair& legs) {
  return only_pair(joints, [&](const std::vector<int>& chain) {
    return chain.size() == 3 && joints.at(chain[0]).y > joints.at(legs.first.upper).y + 0.1F * joints.height;
  });
}

int find_head_shape(const JointMap& joints, const LimbBones& left_arm, const LimbBones& right_arm) {
  const Skeleton& skeleton = joints.skeleton;
  int bone = common_ancestor(skeleton, skeleton.parent(left_arm.upper), skeleton.parent(right_arm.upper));
  if (bone < 0) return -1;
  const int chest = bone;
  for (;;) {
    int above = -1;
    for (const int child : joints.children[static_cast<std::size_t>(bone)]) {
      const bool carries_arm = is_below(skeleton, left_arm.upper, child) || is_below(skeleton, right_arm.upper, child);
      const bool goes_up = joints.at(child).y > joints.at(bone).y + apart * joints.height;
      if (carries_arm || !goes_up) continue;
      if (above >= 0) return bone == chest ? -1 : bone;  // a face begins here, or there are two ways up
      above = child;
    }
    if (above < 0) return bone == chest ? -1 : bone;
    bone = above;
  }
}

std::optional<glm::vec3> toe_direction(const JointMap& joints, const LimbPair& legs) {
  if (legs.first.tip < 0 || legs.second.tip < 0) return std::nullopt;
  const glm::vec3 across = glm::normalize(joints.level(legs.second.upper, legs.first.upper));
  glm::vec3 toes = joints.level(legs.first.end, legs.first.tip) + joints.level(legs.second.end, legs.second.tip);
  toes -= across * glm::dot(toes, across);
  if (glm::length(toes) < apart * joints.height) return std::nullopt;
  return glm::normalize(toes);
}

}  // namespace throng::anim
