#include "assets/wardrobe/body_skin.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "assets/wardrobe/head.h"
#include "assets/wardrobe/make.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

/// Returns an angle, 0 in front, that grows to the wearer's left.
double angle_around_neck(dvec3 place) { return std::atan2(place.x, place.z + 0.020); }

/// Points at open edges below some height, by their angle around the neck.
std::vector<std::size_t> neck_border(const Skin& skin, double below) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const mannequin::SkinFace& face : skin.faces) {
    for (std::size_t c = 0; c < face.corners.size(); ++c) {
      edges.insert({face.corners[c], face.corners[(c + 1) % face.corners.size()]});
    }
  }
  std::vector<std::size_t> loop;
  for (const auto& [a, b] : edges) {
    if (!edges.contains({b, a}) && skin.points[a].position.y < below) loop.push_back(a);
  }
  std::sort(loop.begin(), loop.end(), [&](std::size_t a, std::size_t b) {
    return angle_around_neck(skin.points[a].position) < angle_around_neck(skin.points[b].position);
  });
  return loop;
}

/// Triangles between two rings of different numbers of points, each step to the ring that lags behind.
void zip(Skin& skin, const std::vector<std::size_t>& lower, const std::vector<std::size_t>& upper) {
  const auto angle = [&](const std::vector<std::size_t>& ring, std::size_t i) {
    const double turn = i >= ring.size() ? 2 * M_PI : 0;
    return angle_around_neck(skin.points[ring[i % ring.size()]].position) + turn;
  };
  std::size_t l = 0;
  std::size_t u = 0;
  while (l < lower.size() || u < upper.size()) {
    const bool advance_lower = u >= upper.size() || (l < lower.size() && angle(lower, l + 1) <= angle(upper, u + 1));
    std::vector<std::size_t> corners{lower[l % lower.size()], 0, upper[u % upper.size()]};
    corners[1] = advance_lower ? lower[(l + 1) % lower.size()] : upper[(u + 1) % upper.size()];
    (advance_lower ? l : u) += 1;
    skin.faces.push_back({std::move(corners),
                          mannequin::Region::skin,
                          std::vector<dvec3>(3, dvec3(1)),
                          {.piece = static_cast<unsigned char>(Slot::head)}});
  }
}

Skin build_body_skin() {
  Skin body = mirrored_surface(man_cage());
  const std::vector<std::size_t> lower = neck_border(body, 1e9);
  const Skin head = head_skin();
  const std::size_t first = body.points.size();
  std::vector<std::size_t> upper = neck_border(head, 1.56);
  for (std::size_t& point : upper) point += first;
  append(body, head);
  zip(body, lower, upper);
  return body;
}

}  // namespace

const Skin& body_skin() {
  static const Skin skin = build_body_skin();
  return skin;
}

}  // namespace throng::wardrobe
