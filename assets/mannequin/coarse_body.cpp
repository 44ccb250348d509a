#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/body.h"
#include "assets/mannequin/body_parts.h"
#include "assets/mannequin/closest.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;
using Ring = std::vector<std::size_t>;

/// A horizontal cross-section, an ellipse; metres.
struct Level {
  double height, half_width, front, back;
  double drop_front = 0;  ///< How far its front lies below its sides.
};

/// A cross-section of an arm, along it, or of a leg, by height; metres.
struct LimbLevel {
  double place;
  double half_width, half_depth;
  double x = 0, z = 0;           ///< Of a leg's centre; of an arm's towards the thumb and the back.
  Region region = Region::skin;  ///< Of the faces that lead to it.
};

/// What of the body is left at one level of detail. Rings of the trunk have `half_ring` points from the front to the
/// back of one side, and are bridged in order.
struct Plan {
  std::size_t half_ring;
  std::span<const Level> trunk;  ///< Crease, hem, any number, armpit, shoulder, neck.
  std::span<const Level> head;   ///< From the jaw up.
  std::size_t hair_from;         ///< Index among `head`, below which the front is skin.
  std::span<const LimbLevel> arm, leg, foot;
  bool crotch, eyes;
};

/// A polygon drawn into an outline is too thin, one around it too thick by as much: halfway between.
double widened(std::size_t corners) { return 2 / (1 + std::cos(std::numbers::pi / static_cast<double>(corners))); }

class CoarseBody {
 public:
  explicit CoarseBody(const Plan& plan) : plan_(plan) {}

  Cage build() {
    std::vector<Ring> trunk;
    for (const Level& level : plan_.trunk) trunk.push_back(add_half_ring(level));
    const std::size_t count = trunk.size();
    for (std::size_t i = 0; i + 3 < count; ++i) {
      cage_.bridge(trunk[i], trunk[i + 1], false, i == 0 ? Region::trousers : Region::shirt);
    }
    const Ring armhole = bridge_around_armhole(trunk[count - 3], trunk[count - 2]);
    cage_.bridge(trunk[count - 2], trunk[count - 1], false, Region::shirt);
    add_arm(armhole);
    add_leg(trunk.front());
    add_head(trunk.back());
    return std::move(cage_);
  }

 private:
  static constexpr Weights unbound{};

  Ring add_half_ring(const Level& level) {
    const std::size_t last = plan_.half_ring - 1;
    const double wide = widened(2 * last);
    const double middle = 0.5 * (level.front + level.back);
    const double depth = 0.5 * (level.front - level.back);
    Ring ring;
    for (std::size_t i = 0; i <= last; ++i) {
      const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(last);
      const double across = i == 0 || i == last ? 0 : level.half_width * wide * std::sin(angle);
      const double fore = std::cos(angle);
      ring.push_back(
          cage_.add({across, level.height - level.drop_front * std::max(0.0, fore), middle + depth * fore}, unbound));
    }
    return ring;
  }

  /// The trunk's side between armpit and shoulder stays open. From below over the back to the top and the front.
  Ring bridge_around_armhole(const Ring& low, const Ring& top) {
    const std::size_t last = plan_.half_ring - 1;
    for (const std::size_t i : {std::size_t{0}, last - 1}) {
      cage_.add_face({low[i], low[i + 1], top[i + 1], top[i]}, Region::shirt);
    }
    Ring hole;
    const std::size_t middle = plan_.half_ring / 2;
    for (std::size_t i = middle; i < last; ++i) hole.push_back(low[i]);
    for (std::size_t i = last - 1; i > 0; --i) hole.push_back(top[i]);
    for (std::size_t i = 1; i < middle; ++i) hole.push_back(low[i]);
    return hole;
  }

  void add_arm(Ring ring) {
    const std::size_t corners = ring.size();
    const double wide = widened(corners);
    for (const LimbLevel& level : plan_.arm) {
      Ring next;
      for (std::size_t k = 0; k < corners; ++k) {
        const double turn = corners == 4 ? 0.5 : 0.0;
        const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + turn) / static_cast<double>(corners);
        next.push_back(cage_.add(left_arm().at(level.place, level.x - wide * level.half_width * std::sin(angle),
                                               level.z - wide * level.half_depth * std::cos(angle)),
                                 unbound));
      }
      cage_.bridge(ring, next, true, level.region);
      ring = next;
    }
    cage_.add_face(ring, Region::skin);
  }

  void add_leg(const Ring& crease) {
    Ring ring = crease;
    if (plan_.crotch) ring.push_back(cage_.add({0, 0.832, 0.006}, unbound));
    const std::size_t corners = ring.size();
    for (const LimbLevel& level : plan_.leg) ring = add_leg_ring(ring, level, widened(corners));
    for (const LimbLevel& level : plan_.foot) ring = add_leg_ring(ring, level, 1.0);
    std::reverse(ring.begin(), ring.end());
    cage_.add_face(ring, Region::shoes, dvec3(0.55));
  }

  Ring add_leg_ring(const Ring& upper, const LimbLevel& level, double wide) {
    const std::size_t corners = upper.size();
    Ring ring;
    for (std::size_t k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * (static_cast<double>(k) - 0.5) / static_cast<double>(corners);
      ring.push_back(cage_.add({level.x + wide * level.half_width * std::sin(angle), level.place,
                                level.z + wide * level.half_depth * std::cos(angle)},
                               unbound));
    }
    cage_.bridge(ring, upper, true, level.region);
    return ring;
  }

  void add_head(Ring ring) {
    for (std::size_t level = 0; level < plan_.head.size(); ++level) {
      const Ring next = add_half_ring(plan_.head[level]);
      for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const bool behind = level > 0 && 2 * (i + 1) >= ring.size();
        const bool hair = level >= plan_.hair_from || behind;
        const std::size_t face =
            cage_.add_face({ring[i], ring[i + 1], next[i + 1], next[i]}, hair ? Region::hair : Region::skin);
        if (plan_.eyes && i == 0 && level + 1 == plan_.hair_from) add_eye(face);
      }
      ring = next;
    }
    cage_.add_face(ring, Region::hair);
  }

  void add_eye(std::size_t face) {
    constexpr std::array<dvec3, 4> corners{
        {{0.0215, 1.6665, 0.0935}, {0.0450, 1.6675, 0.0850}, {0.0450, 1.6835, 0.0850}, {0.0215, 1.6835, 0.0945}}};
    std::array<std::size_t, 4> eye{};
    for (std::size_t i = 0; i < 4; ++i) eye[i] = cage_.add(corners[i], unbound);
    cage_.inset(face, eye);
    cage_.faces[face].paint.assign(4, dvec3(0.30, 0.24, 0.23));
  }

  const Plan& plan_;
  Cage cage_;
};

/// Weights, shading and openness from the nearest place of the smooth skin.
Skin skin_of(const Cage& cage, const Skin& full) {
  const auto triangles = triangles_of(full);
  Skin skin;
  for (const CageVertex& vertex : cage.vertices) {
    const ClosestPlace place = closest_place(vertex.position, full, triangles);
    SkinPoint point{.position = vertex.position, .openness = 0, .weights = {}};
    for (std::size_t c = 0; c < 3; ++c) {
      const SkinPoint& corner = full.points[triangles[place.triangle][c]];
      point.openness += place.shares[c] * corner.openness;
      for (std::size_t j = 0; j < joint_count; ++j) point.weights[j] += place.shares[c] * corner.weights[j];
    }
    skin.points.push_back(point);
  }
  for (const CageFace& face : cage.faces) skin.faces.push_back({face.corners, face.region, face.paint});
  compute_normals(skin);
  return skin;
}

constexpr double sleeve = 0.170;

}  // namespace

Skin make_medium_skin(const Skin& full) {
  constexpr std::array<Level, 7> trunk{{{0.905, 0.170, 0.104, -0.134, 0.040},
                                        {0.958, 0.173, 0.111, -0.141, 0.006},
                                        {1.065, 0.150, 0.103, -0.098},
                                        {1.250, 0.162, 0.115, -0.116},
                                        {1.345, 0.172, 0.112, -0.116},
                                        {1.470, 0.168, 0.064, -0.100, 0.022},
                                        {1.513, 0.068, 0.043, -0.081, 0.030}}};
  constexpr std::array<Level, 5> head{{{1.590, 0.062, 0.0915, -0.101, 0.020},
                                       {1.645, 0.0735, 0.106, -0.116},
                                       {1.704, 0.0770, 0.0975, -0.122},
                                       {1.752, 0.0765, 0.092, -0.120},
                                       {1.788, 0.056, 0.058, -0.092}}};
  constexpr std::array<LimbLevel, 6> arm{{{sleeve, 0.054, 0.054, 0, 0, Region::shirt},
                                          {0.255, 0.040, 0.039},
                                          {0.310, 0.041, 0.039},
                                          {0.400, 0.040, 0.036},
                                          {0.535, 0.028, 0.021},
                                          {0.610, 0.043, 0.017}}};
  constexpr std::array<LimbLevel, 5> leg{{{0.790, 0.087, 0.094, 0.094, -0.006, Region::trousers},
                                          {0.530, 0.063, 0.068, 0.098, 0.004, Region::trousers},
                                          {0.455, 0.060, 0.064, 0.098, 0.002, Region::trousers},
                                          {0.335, 0.060, 0.067, 0.100, -0.014, Region::trousers},
                                          {0.085, 0.051, 0.060, 0.102, -0.018, Region::trousers}}};
  constexpr std::array<LimbLevel, 2> foot{
      {{0.055, 0.042, 0.115, 0.105, 0.036, Region::shoes}, {0.000, 0.047, 0.150, 0.107, 0.050, Region::shoes}}};
  std::array<LimbLevel, 7> arm_and_fingers{};
  std::copy(arm.begin(), arm.end(), arm_and_fingers.begin());
  arm_and_fingers.back() = {0.705, 0.034, 0.012, -0.002, -0.026};
  const Plan plan{5, trunk, head, 3, arm_and_fingers, leg, foot, true, true};
  return skin_of(mirrored(CoarseBody(plan).build()), full);
}

Skin make_smallest_skin(const Skin& full) {
  constexpr std::array<Level, 5> trunk{{{0.880, 0.165, 0.098, -0.136, 0.020},
                                        {0.965, 0.165, 0.104, -0.122},
                                        {1.345, 0.168, 0.114, -0.120},
                                        {1.472, 0.160, 0.062, -0.098, 0.022},
                                        {1.520, 0.062, 0.042, -0.080, 0.020}}};
  constexpr std::array<Level, 3> head{
      {{1.590, 0.064, 0.094, -0.100, 0.018}, {1.715, 0.0785, 0.100, -0.122}, {1.797, 0.050, 0.052, -0.086}}};
  // The sleeve ends at the elbow, so that one ring serves both.
  constexpr std::array<LimbLevel, 2> arm{
      {{0.262, 0.044, 0.043, 0, 0, Region::shirt}, {0.690, 0.036, 0.016, 0, -0.018}}};
  constexpr std::array<LimbLevel, 2> leg{
      {{0.495, 0.062, 0.066, 0.098, 0.003, Region::trousers}, {0.085, 0.051, 0.060, 0.102, -0.018, Region::trousers}}};
  constexpr std::array<LimbLevel, 1> foot{{{0.000, 0.058, 0.182, 0.105, 0.048, Region::shoes}}};
  const Plan plan{4, trunk, head, 2, arm, leg, foot, false, false};
  return skin_of(mirrored(CoarseBody(plan).build()), full);
}

}  // namespace throng::mannequin
