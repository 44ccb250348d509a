#include "engine/anim/asset/bake_ground_speed.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "engine/anim/asset/bake_surface.h"

namespace throng::anim {

namespace {

constexpr std::size_t instants = 96;
constexpr double tall_person = 1.8;     // metres: what the limits below are meant for
constexpr double least_stride = 0.06;   // metres over the ground: a joint that strides less is no foot
constexpr double least_speed = 0.25;    // metres a second
constexpr double stance_height = 0.05;  // metres above the lowest point of all: higher joints are in flight
constexpr double agreement = 0.5;       // a sample agrees with the median that is within this share of it
constexpr double least_agreeing = 0.5;  // of the stance samples
constexpr std::size_t least_stances = instants / 10;

using Joints = std::vector<BoneFrame>;

std::vector<Joints> sample_joints(const Skeleton& skeleton, const KeyframeStream& stream) {
  ExactPoses poses(stream);
  std::vector<Joints> samples(instants + 1, Joints(skeleton.bones.size()));
  for (std::size_t i = 0; i <= instants; ++i) {
    compute_frames(skeleton, poses.at(stream.duration * static_cast<Ticks>(i) / static_cast<Ticks>(instants)),
                   samples[i]);
  }
  return samples;
}

/// Joints that go to and fro over the ground, as feet do, and not only up and down.
std::vector<std::size_t> striding_joints(const std::vector<Joints>& samples, double least) {
  std::vector<std::size_t> striding;
  for (std::size_t joint = 0; joint < samples.front().size(); ++joint) {
    const glm::dvec3 start = samples.front()[joint].origin;
    const bool strides = std::ranges::any_of(samples, [&](const Joints& joints) {
      const glm::dvec3 moved = joints[joint].origin - start;
      return std::hypot(moved.x, moved.z) > least;
    });
    if (strides) striding.push_back(joint);
  }
  return striding;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Ground-plane velocities of the lowest joint, while it is on the ground.
std::vector<glm::dvec2> stance_velocities(const std::vector<Joints>& samples, std::span<const std::size_t> joints,
                                          double seconds, double band) {
  const auto height = [&](std::size_t i, std::size_t joint) { return samples[i][joint].origin.y; };
  std::vector<std::size_t> lowest;
  double ground = height(0, joints.front());
  for (std::size_t i = 0; i < instants; ++i) {
    lowest.push_back(*std::ranges::min_element(joints, {}, [&](std::size_t joint) { return height(i, joint); }));
    ground = std::min(ground, height(i, lowest.back()));
  }
  std::vector<glm::dvec2> velocities;
  for (std::size_t i = 0; i < instants; ++i) {
    if (height(i, lowest[i]) > ground + band) continue;
    const glm::dvec3 moved = samples[i + 1][lowest[i]].origin - samples[i][lowest[i]].origin;
    velocities.emplace_back(moved.x / seconds, moved.z / seconds);
  }
  return velocities;
}

glm::dvec2 median(std::span<const glm::dvec2> velocities) {
  std::vector<double> x;
  std::vector<double> z;
  for (const glm::dvec2& velocity : velocities) {
    x.push_back(velocity.x);
    z.push_back(velocity.y);
  }
  return {median(std::move(x)), median(std::move(z))};
}

}  // namespace

double stance_speed(const Skeleton& skeleton, const KeyframeStream& stream, double height) {
  const double size = height / tall_person;
  const std::vector<Joints> samples = sample_joints(skeleton, stream);
  const std::vector<std::size_t> striding = striding_joints(samples, least_stride * size);
  if (striding.empty()) return 0.0;
  const double seconds = to_seconds(stream.duration) / static_cast<double>(instants);
  const std::vector<glm::dvec2> velocities = stance_velocities(samples, striding, seconds, stance_height * size);
  if (velocities.size() < least_stances) return 0.0;
  const glm::dvec2 typical = median(velocities);
  const double speed = glm::length(typical);
  if (speed < least_speed * size) return 0.0;
  const auto agreeing = std::ranges::count_if(
      velocities, [&](const glm::dvec2& velocity) { return glm::distance(velocity, typical) < agreement * speed; });
  const double share = static_cast<double>(agreeing) / static_cast<double>(velocities.size());
  return share < least_agreeing ? 0.0 : speed;
}

}  // namespace throng::anim
