#include "engine/anim/bake/stride.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "engine/anim/bake/surface.h"

namespace throng::anim {

namespace {

constexpr double least_stride = 0.06;   // metres over the ground: a foot strides at least so far
constexpr double stance_height = 0.05;  // metres above the lowest place of any foot: higher joints are in flight
constexpr double agreement = 0.5;       // a velocity within this share of a typical one agrees with it

/// Returns the height up to which a joint may be a foot: feet rest low, and hands that swing lower than feet do not.
double highest_foot(const Skeleton& skeleton) {
  constexpr double share = 0.2;  // of the way from the lowest joint to the highest, in the rest pose
  const auto [lowest, highest] =
      std::ranges::minmax(skeleton.references, {}, [](const ReferenceFrame& reference) { return reference.origin.y; });
  return lowest.origin.y + share * (highest.origin.y - lowest.origin.y);
}

bool strides(const Stride& stride, std::size_t joint) {
  const glm::dvec3 start = stride.at(0, joint);
  return std::ranges::any_of(stride.joints, [&](const std::vector<glm::dvec3>& joints) {
    const glm::dvec3 moved = joints[joint] - start;
    return glm::length(glm::dvec2(moved.x, moved.z)) > least_stride * stride.size;
  });
}

}  // namespace

std::size_t Stride::lowest(std::size_t instant, std::span<const std::size_t> among) const {
  return *std::ranges::min_element(among, {}, [&](std::size_t joint) { return at(instant, joint).y; });
}

bool Stride::is_low(std::size_t instant, std::size_t joint) const {
  return at(instant, joint).y <= ground + stance_height * size;
}

glm::dvec2 Stride::velocity(std::size_t instant, std::size_t joint) const {
  const glm::dvec3 moved = at(instant + 1, joint) - at(instant, joint);
  return {moved.x / step, moved.z / step};
}

Stride sample_stride(const Skeleton& skeleton, const BakedClip& clip, double height) {
  Stride stride{.joints = {},
                .feet = {},
                .step = to_seconds(clip.duration) / static_cast<double>(stride_instants),
                .size = height / tall_person,
                .ground = std::numeric_limits<double>::infinity()};
  ClipPoses poses(clip.keyframe(), clip.sampled());
  std::vector<BoneFrame> frames(skeleton.bones.size());
  for (std::size_t i = 0; i <= stride_instants; ++i) {
    const Ticks time = clip.duration * static_cast<std::int64_t>(i) / static_cast<std::int64_t>(stride_instants);
    compute_frames(skeleton, poses.at(time), frames);
    std::vector<glm::dvec3>& joints = stride.joints.emplace_back();
    for (const BoneFrame& frame : frames) joints.push_back(frame.origin);
  }
  const double highest = highest_foot(skeleton);
  for (std::size_t joint = 0; joint < frames.size(); ++joint) {
    if (skeleton.references[joint].origin.y <= highest && strides(stride, joint)) stride.feet.push_back(joint);
  }
  for (std::size_t i = 0; i < stride_instants && !stride.feet.empty(); ++i) {
    stride.ground = std::min(stride.ground, stride.at(i, stride.lowest(i, stride.feet)).y);
  }
  return stride;
}

bool agrees(const glm::dvec2& velocity, const glm::dvec2& typical) {
  return glm::distance(velocity, typical) < agreement * glm::length(typical);
}

}  // namespace throng::anim
