#include "engine/anim/asset/bake_ground_speed.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/anim/asset/bake_surface.h"

namespace throng::anim {

namespace {

constexpr int instants = 96;
constexpr double tall_person = 1.8;     // metres: what the limits below are meant for
constexpr double least_motion = 0.01;   // metres: a joint that moves less bears no step
constexpr double least_speed = 0.15;    // metres a second
constexpr double agreement = 0.35;      // a sample agrees with the median that is within this share of it
constexpr double least_agreeing = 0.5;  // of all samples

using Joints = std::vector<BoneFrame>;

std::vector<Joints> sample_joints(const Skeleton& skeleton, const KeyframeStream& stream) {
  ExactPoses poses(stream);
  std::vector<Joints> samples(instants + 1, Joints(skeleton.bones.size()));
  for (int i = 0; i <= instants; ++i) {
    compute_frames(skeleton, poses.at(stream.duration * i / instants), samples[static_cast<std::size_t>(i)]);
  }
  return samples;
}

std::vector<std::size_t> moving_joints(const std::vector<Joints>& samples, double least) {
  std::vector<std::size_t> moving;
  for (std::size_t joint = 0; joint < samples.front().size(); ++joint) {
    const bool moves = std::ranges::any_of(samples, [&](const Joints& joints) {
      return glm::distance(joints[joint].origin, samples.front()[joint].origin) > least;
    });
    if (moves) moving.push_back(joint);
  }
  return moving;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

double stance_speed(const Skeleton& skeleton, const KeyframeStream& stream, double height) {
  const double size = height / tall_person;
  const std::vector<Joints> samples = sample_joints(skeleton, stream);
  const std::vector<std::size_t> moving = moving_joints(samples, least_motion * size);
  if (moving.empty()) return 0.0;
  const double seconds = to_seconds(stream.duration) / instants;
  std::vector<double> across;
  std::vector<double> along;
  for (std::size_t i = 0; i < instants; ++i) {
    const auto lowest =
        *std::ranges::min_element(moving, {}, [&](std::size_t joint) { return samples[i][joint].origin.y; });
    const glm::dvec3 velocity = (samples[i + 1][lowest].origin - samples[i][lowest].origin) / seconds;
    across.push_back(velocity.x);
    along.push_back(velocity.z);
  }
  const glm::dvec2 typical(median(across), median(along));
  const double speed = glm::length(typical);
  if (speed < least_speed * size) return 0.0;
  int agreeing = 0;
  for (std::size_t i = 0; i < instants; ++i) {
    if (glm::distance(glm::dvec2(across[i], along[i]), typical) < agreement * speed) ++agreeing;
  }
  return agreeing < least_agreeing * instants ? 0.0 : speed;
}

}  // namespace throng::anim
