#include "assets/wardrobe/build_shares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/making/triangle.h"
#include "assets/mannequin/shape.h"
#include "assets/wardrobe/body_skin.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

bool is_of_arm(Slot piece) { return piece == Slot::upper_arms || piece == Slot::forearms || piece == Slot::hands; }

/// A triangle of the man's skin, with a ball around it.
struct SkinTriangle {
  std::array<std::size_t, 3> corners;
  dvec3 middle;
  double radius;
  bool of_arm;
};

const Skin& skin_with_normals() {
  static const Skin skin = [] {
    Skin all = body_skin();
    mannequin::compute_normals(all);
    return all;
  }();
  return skin;
}

std::vector<SkinTriangle> cut_skin() {
  std::vector<SkinTriangle> triangles;
  const Skin& skin = skin_with_normals();
  for (const mannequin::SkinFace& face : skin.faces) {
    for (std::size_t c = 1; c + 1 < face.corners.size(); ++c) {
      const std::array<std::size_t, 3> corners{face.corners[0], face.corners[c], face.corners[c + 1]};
      const auto at = [&](std::size_t k) { return skin.points[corners[k]].position; };
      const dvec3 middle = (at(0) + at(1) + at(2)) / 3.0;
      const double radius =
          std::max({glm::distance(at(0), middle), glm::distance(at(1), middle), glm::distance(at(2), middle)});
      triangles.push_back({corners, middle, radius, is_of_arm(static_cast<Slot>(face.notes.piece))});
    }
  }
  return triangles;
}

double arm_share(const mannequin::Weights& weights) {
  double share = 0;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    const std::string_view joint = mannequin::skeleton()[j].name;
    if (joint.starts_with("upper_arm") || joint.starts_with("forearm") || joint.starts_with("hand"))
      share += weights[j];
  }
  return share;
}

/// Returns normal and weights of the nearest skin of the same side and limb.
mannequin::SkinPoint skin_below(const mannequin::SkinPoint& point) {
  static const std::vector<SkinTriangle> triangles = cut_skin();
  const auto& points = skin_with_normals().points;
  const dvec3 place = point.position;
  const bool of_arm = arm_share(point.weights) > 0.6;
  double nearest = std::numeric_limits<double>::infinity();
  mannequin::SkinPoint best = point;
  for (const SkinTriangle& triangle : triangles) {
    if (triangle.of_arm != of_arm || triangle.middle.x * place.x < -1e-4) continue;
    if (glm::distance(triangle.middle, place) - triangle.radius > nearest) continue;
    const auto& [a, b, c] = triangle.corners;
    const dvec3 shares = making::nearest_shares(place, points[a].position, points[b].position, points[c].position);
    const dvec3 there = shares.x * points[a].position + shares.y * points[b].position + shares.z * points[c].position;
    const double distance = glm::distance(there, place);
    if (distance >= nearest - 1e-9) continue;
    nearest = distance;
    best.normal =
        glm::normalize(shares.x * points[a].normal + shares.y * points[b].normal + shares.z * points[c].normal);
    for (std::size_t j = 0; j < mannequin::joint_count; ++j) {
      best.weights[j] =
          shares.x * points[a].weights[j] + shares.y * points[b].weights[j] + shares.z * points[c].weights[j];
    }
  }
  return best;
}

/// A belly is stouter than the joints behind it.
double belly(dvec3 place) {
  const dvec3 offset = (place - dvec3(0, 1.06, 0.10)) / dvec3(0.13, 0.10, 0.09);
  return 0.45 * std::exp(-glm::dot(offset, offset));
}

}  // namespace

BuildShares::BuildShares(const Skin& surface) {
  constexpr double faces_along = 0.35;  // the cosine from which a surface faces as the skin does
  for (const mannequin::SkinPoint& point : surface.points) {
    Below below;
    const mannequin::SkinPoint skin = skin_below(point);
    const dvec3 normal = skin.normal;
    // Clothes over each other hang from other joints, but must grow alike. At the shoulder arms and trunk blend.
    below.shares = glm::mix(mannequin::shape_by_joints(skin.weights), mannequin::shape_by_joints(point.weights),
                            glm::smoothstep(0.1, 0.5, arm_share(point.weights)));
    below.shares.x += belly(point.position);
    const double cosine = glm::dot(normal, point.normal);
    if (cosine < -faces_along) below.shares *= dvec3(-1, -1, 1);
    if (std::abs(cosine) <= faces_along) below.normal = normal;
    below.shares = glm::clamp(below.shares, -1.0, 1.0);
    below_.push_back(below);
  }
}

void BuildShares::turn_normals(Skin& surface) const {
  for (std::size_t p = 0; p < below_.size(); ++p) {
    if (below_[p].normal == dvec3(0)) continue;
    surface.points[p].normal =
        glm::round(below_[p].normal / mannequin::normal_step) * mannequin::normal_step + dvec3(0);
  }
}

void BuildShares::set_shares(mannequin::Mesh& mesh) const {
  for (mannequin::MeshVertex& vertex : mesh.vertices) {
    vertex.shape = glm::round(below_[vertex.point].shares / mannequin::shape_step) * mannequin::shape_step + dvec3(0);
  }
}

}  // namespace throng::wardrobe
