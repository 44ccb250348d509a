#include "engine/anim/rig/ragdoll_shapes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

#include "engine/anim/base/box.h"

namespace throng::anim {
namespace {

std::size_t nth(int index) { return static_cast<std::size_t>(index); }

/// Radii of RagdollPart as shares of the height, as measured on a person: pelvis, spine, chest, head; upper arm,
/// forearm, hand; thigh, shin, foot.
constexpr std::array usual_radii{0.064, 0.062, 0.068, 0.052, 0.026, 0.022, 0.018, 0.042, 0.030, 0.022};
static_assert(usual_radii.size() == static_cast<std::size_t>(RagdollPart::other));

double usual_radius(RagdollPart part, double height, double length) {
  if (part == RagdollPart::other) return std::clamp(0.2 * length, 0.01 * height, 0.06 * height);
  return usual_radii.at(static_cast<std::size_t>(part)) * height;
}

class ShapeFitter {
 public:
  ShapeFitter(const Model& model, std::span<const RagdollBone> chosen)
      : skeleton_(model.skeleton), chosen_(chosen), body_of_(skeleton_.bones.size(), -1), points_(chosen.size()) {
    for (std::size_t body = 0; body < chosen.size(); ++body) body_of_[nth(chosen[body].bone)] = static_cast<int>(body);
    for (std::size_t bone = 0; bone < body_of_.size(); ++bone) {
      const int parent = skeleton_.bones[bone].parent;
      if (body_of_[bone] < 0 && parent >= 0) body_of_[bone] = body_of_[nth(parent)];
    }
    for (const SkinnedMesh& mesh : model.meshes) collect(mesh);
    Box box;
    for (const RagdollBone& bone : chosen) box.add(origin(bone.bone));
    height_ = 1.1 * std::max({box.size().x, box.size().y, box.size().z, 1e-6});
  }

  RagdollShape fit(int body) const {
    RagdollShape shape{.joint = origin(chosen_[nth(body)].bone)};
    shape.from = shape.joint;
    shape.to = end_of(body);
    if (chosen_[nth(body)].part == RagdollPart::pelvis) lie_between_the_hips(shape);
    if (glm::distance(shape.from, shape.to) < 1e-3 * height_)
      shape.to = shape.from + glm::dvec3(0.0, 0.01 * height_, 0.0);
    shape.radius = radius(body, shape);
    return shape;
  }

 private:
  glm::dvec3 origin(int bone) const { return skeleton_.references[nth(bone)].origin; }

  void collect(const SkinnedMesh& mesh) {
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
      const int bone = skeleton_.palette[mesh.palette_entries[vertex][0]].bone;
      if (body_of_[nth(bone)] >= 0) points_[nth(body_of_[nth(bone)])].emplace_back(mesh.positions[vertex]);
    }
  }

  glm::dvec3 end_of(int body) const {
    const RagdollBone& own = chosen_[nth(body)];
    const glm::dvec3 joint = origin(own.bone);
    if (const auto children = ends_of_children(body); !children.empty()) return middle(children);
    if (!points_[nth(body)].empty()) return joint + 1.9 * (middle(points_[nth(body)]) - joint);
    const glm::dvec3 along = own.parent < 0 ? glm::dvec3(0.0, 1.0, 0.0) : joint - origin(chosen_[nth(own.parent)].bone);
    if (own.part == RagdollPart::head) return joint + 0.11 * height_ * glm::normalize(along);
    glm::dvec3 farthest = joint + 0.01 * along;
    for (int bone = own.bone; bone < skeleton_.bone_count(); ++bone) {
      if (body_of_[nth(bone)] != body) continue;
      if (glm::distance(origin(bone), joint) > glm::distance(farthest, joint)) farthest = origin(bone);
    }
    const bool has_length = glm::distance(farthest, joint) > 0.02 * glm::length(along);
    return has_length ? farthest : joint + 0.5 * along;
  }

  /// Returns the joints of the bodies that hang on this one: all of them for a part of a person, else the farthest.
  std::vector<glm::dvec3> ends_of_children(int body) const {
    std::vector<glm::dvec3> ends;
    for (const RagdollBone& child : chosen_) {
      if (child.parent == body) ends.push_back(origin(child.bone));
    }
    if (chosen_[nth(body)].part != RagdollPart::other || ends.size() < 2) return ends;
    const glm::dvec3 joint = origin(chosen_[nth(body)].bone);
    const auto distance = [&](const glm::dvec3& end) { return glm::distance(end, joint); };
    return {*std::ranges::max_element(ends, {}, distance)};
  }

  static glm::dvec3 middle(const std::vector<glm::dvec3>& points) {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& point : points) sum += point;
    return sum / static_cast<double>(points.size());
  }

  void lie_between_the_hips(RagdollShape& shape) const {
    for (const RagdollBone& bone : chosen_) {
      if (bone.part == RagdollPart::thigh) (bone.side > 0 ? shape.to : shape.from) = origin(bone.bone);
    }
    const glm::dvec3 rise = 0.5 * (shape.joint - 0.5 * (shape.from + shape.to));
    shape.from += rise;
    shape.to += rise;
  }

  double radius(int body, const RagdollShape& shape) const {
    const glm::dvec3 along = shape.to - shape.from;
    if (points_[nth(body)].size() < 8) return usual_radius(chosen_[nth(body)].part, height_, glm::length(along));
    double sum = 0.0;
    for (const glm::dvec3& point : points_[nth(body)]) {
      const double t = std::clamp(glm::dot(point - shape.from, along) / glm::dot(along, along), 0.0, 1.0);
      sum += glm::distance(point, shape.from + t * along);
    }
    return std::clamp(sum / static_cast<double>(points_[nth(body)].size()), 0.01 * height_, 0.1 * height_);
  }

  const Skeleton& skeleton_;
  std::span<const RagdollBone> chosen_;
  std::vector<int> body_of_;  ///< one a bone: the body that carries it, or -1
  std::vector<std::vector<glm::dvec3>> points_;
  double height_ = 0.0;
};

/// Bodies resist turning this many times more than they should. A limit turns one body, but swings all that hangs on
/// it: with the inertia of the body alone, a limit would need hundreds of passes.
constexpr double sluggish = 3.0;

double volume(const RagdollShape& shape) {
  const double r = shape.radius;
  return std::numbers::pi * r * r * (glm::distance(shape.from, shape.to) + r / 3.0);
}

}  // namespace

std::vector<RagdollShape> fit_ragdoll_shapes(const Model& model, std::span<const RagdollBone> chosen) {
  const ShapeFitter fitter(model, chosen);
  std::vector<RagdollShape> shapes;
  for (std::size_t body = 0; body < chosen.size(); ++body) shapes.push_back(fitter.fit(static_cast<int>(body)));
  return shapes;
}

void set_ragdoll_masses(std::span<const RagdollShape> shapes, double mass, std::span<RagdollBody> bodies) {
  double total = 0.0;
  for (const RagdollShape& shape : shapes) total += volume(shape);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const RagdollShape& shape = shapes[b];
    const double length = glm::distance(shape.from, shape.to);
    // A hand of a hundredth of its arm's mass would shake: position-based joints need neighbours of similar mass.
    const double own = mass * std::max(volume(shape) / total, 0.015);
    const double across = sluggish * own * (3.0 * shape.radius * shape.radius + length * length) / 12.0;
    // For the same reason a thin limb turns about itself more slowly than it should.
    const double axial = std::max(0.5 * sluggish * own * shape.radius * shape.radius, across / 3.0);
    const glm::dvec3 center = 0.5 * (shape.from + shape.to);
    RagdollBody& body = bodies[b];
    body.center = center;
    body.joint = shape.joint - center;
    body.axis = (shape.to - shape.from) / length;
    body.half_length = static_cast<float>(std::max(0.5 * (length - shape.radius), 0.0));
    body.radius = static_cast<float>(shape.radius);
    body.inverse_mass = static_cast<float>(1.0 / own);
    body.inverse_inertia = static_cast<float>(1.0 / across);
    body.inverse_axial_inertia = static_cast<float>(1.0 / axial);
  }
}

}  // namespace throng::anim
