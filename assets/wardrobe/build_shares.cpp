#include "assets/wardrobe/build_shares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/making/triangle.h"
#include "assets/mannequin/shape.h"
#include "assets/wardrobe/body_skin.h"
#include "assets/wardrobe/part.h"
#include "assets/wardrobe/warp.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

bool is_of_arm(Slot piece) { return piece == Slot::upper_arms || piece == Slot::forearms || piece == Slot::hands; }

struct SkinTriangle {
  making::BoundedTriangle bounds;
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
      triangles.push_back(
          {making::bounded(corners, at(0), at(1), at(2)), is_of_arm(static_cast<Slot>(face.notes.piece))});
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

/// Returns the nearest place on the skin of the same side and limb.
SkinPlace place_below(const mannequin::SkinPoint& point) {
  static const std::vector<SkinTriangle> triangles = cut_skin();
  const auto& points = skin_with_normals().points;
  const dvec3 place = point.position;
  const bool of_arm = arm_share(point.weights) > 0.6;
  const auto may_use = [&](const SkinTriangle& triangle) {
    return triangle.of_arm == of_arm && triangle.bounds.middle.x * place.x >= -1e-4;
  };
  const auto position = [&](std::size_t of) { return points[of].position; };
  return making::nearest_place(place, std::span(triangles), position, may_use);
}

dvec3 normal_at(const SkinPlace& place, const Skin& skin) {
  dvec3 normal(0);
  for (int c = 0; c < 3; ++c) {
    normal += place.shares[c] * skin.points[place.corners[static_cast<std::size_t>(c)]].normal;
  }
  return glm::normalize(normal);
}

dvec3 shape_at(const SkinPlace& place) {
  mannequin::Weights weights{};
  for (int c = 0; c < 3; ++c) {
    const mannequin::Weights& of_corner =
        skin_with_normals().points[place.corners[static_cast<std::size_t>(c)]].weights;
    for (std::size_t j = 0; j < weights.size(); ++j) weights[j] += place.shares[c] * of_corner[j];
  }
  return mannequin::shape_by_joints(weights);
}

/// The skin of a body, with its own normals.
const Skin& skin_of(Body body) {
  static const std::array<Skin, all_bodies.size()> skins = [] {
    std::array<Skin, all_bodies.size()> made;
    for (const Body each : all_bodies) {
      Skin& skin = made[static_cast<std::size_t>(each)];
      skin = body_skin();
      for (mannequin::SkinPoint& point : skin.points) point.position = warped(each, point.position, point.weights);
      mannequin::compute_normals(skin);
    }
    return made;
  }();
  return skins[static_cast<std::size_t>(body)];
}

/// A belly is stouter than the joints behind it.
double belly(dvec3 place) {
  const dvec3 offset = (place - dvec3(0, 1.06, 0.10)) / dvec3(0.13, 0.10, 0.09);
  return 0.45 * std::exp(-glm::dot(offset, offset));
}

}  // namespace

BuildShares::BuildShares(const Skin& surface) {
  constexpr double along = 0.5;  // the cosine from which a surface faces as the skin does
  for (const mannequin::SkinPoint& point : surface.points) {
    Below below{.place = place_below(point)};
    // Clothes over each other hang from other joints, but must grow alike. At the shoulder arms and trunk blend.
    below.shares = glm::mix(shape_at(below.place), mannequin::shape_by_joints(point.weights),
                            glm::smoothstep(0.1, 0.5, arm_share(point.weights)));
    below.shares.x += belly(point.position);
    const double cosine = glm::dot(normal_at(below.place, skin_with_normals()), point.normal);
    if (cosine < -along) below.shares *= dvec3(-1, -1, 1);
    below.faces_along = std::abs(cosine) <= along;
    below.shares = glm::clamp(below.shares, -1.0, 1.0);
    below_.push_back(below);
  }
}

void BuildShares::turn_normals(Skin& surface, Body body) const {
  for (std::size_t p = 0; p < below_.size(); ++p) {
    if (!below_[p].faces_along) continue;
    const dvec3 normal = normal_at(below_[p].place, skin_of(body));
    surface.points[p].normal = glm::round(normal / mannequin::normal_step) * mannequin::normal_step + dvec3(0);
  }
}

void BuildShares::set_shares(mannequin::Mesh& mesh) const {
  for (mannequin::MeshVertex& vertex : mesh.vertices) {
    vertex.shape = glm::round(below_[vertex.point].shares / mannequin::shape_step) * mannequin::shape_step + dvec3(0);
  }
}

}  // namespace throng::wardrobe
