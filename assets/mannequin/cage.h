#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "assets/mannequin/skeleton.h"

namespace throng::mannequin {

/// Names the parts that an instance tints apart, by the vertex attribute _REGION. The wardrobe alone has the last
/// three.
enum class Region : unsigned char {
  skin = 0,
  hair = 1,
  shirt = 2,
  trousers = 3,
  shoes = 4,
  untinted = 5,
  outer = 6,
  headgear = 7,
  thing = 8
};

/// Says how a face gets its coordinates of patterns.
enum class Chart : unsigned char {
  by_joints,    ///< Around the arm, the leg or the trunk, whichever moves it.
  around_body,  ///< Around the trunk, also where legs move it: skirts, coats.
  from_front,   ///< Straight from the front: u is x, v is the height.
  from_side     ///< Straight from the side: u is z, v is the height.
};

/// Keeps what the wardrobe knows of a face. The built-in character has no use for it.
struct FaceNotes {
  unsigned char piece = 0;  ///< Which piece of a body it belongs to.
  double trim = 0;          ///< How much it shows the second colour of a pattern of trim, 0 to 1.
  Chart chart = Chart::by_joints;
};

/// Weight of every joint; sums to one.
using Weights = std::array<double, joint_count>;

/// Shares of joints by name, as authored; divided by their sum.
Weights bind(std::initializer_list<std::pair<std::string_view, double>> shares);

struct CageVertex {
  glm::dvec3 position;
  Weights weights;
};

struct CageFace {
  std::vector<std::size_t> corners;  ///< Counter-clockwise seen from outside.
  Region region;
  std::vector<glm::dvec3> paint;  ///< Per corner, the albedo factor of the quarter at that corner.
  /// A quad that is only halved, across the edges from corner 0 to 1 and from 2 to 3; so must be the quads beyond the
  /// other two edges. For the straight stretches of a limb and for hems.
  bool straight = false;
  FaceNotes notes = {};
};

/// The coarse control mesh of the left half of the body (x >= 0), open along the plane x = 0.
/// Every vertex is authored where the smooth surface shall pass.
struct Cage {
  std::vector<CageVertex> vertices;
  std::vector<CageFace> faces;
  FaceNotes notes = {};  ///< Of the faces that are added from now on.

  std::size_t add(glm::dvec3 position, const Weights& weights);
  std::size_t add_face(std::vector<std::size_t> corners, Region region, glm::dvec3 paint = glm::dvec3(1));
  /// Quads between two rows of equal length, `upper` lying to the left of `lower` when walking along them outside.
  void bridge(std::span<const std::size_t> lower, std::span<const std::size_t> upper, bool closed, Region region,
              glm::dvec3 paint = glm::dvec3(1), bool straight = false);
  /// Replaces a face by a ring of quads and a new inner face with the given corners; returns the inner face.
  std::size_t inset(std::size_t face, std::span<const std::size_t> inner, bool straight = false);
  /// Lifts the faces of a region off the surface and walls its border, but not along the plane x = 0.
  void lift(Region region, const std::function<glm::dvec3(glm::dvec3 position, glm::dvec3 normal)>& displacement);
};

/// The whole closed cage: the half and its mirror image, welded along the plane x = 0.
Cage mirrored(const Cage& half);

}  // namespace throng::mannequin
