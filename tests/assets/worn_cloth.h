#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "assets/mannequin/mesh.h"
#include "assets/mannequin/pose.h"
#include "assets/wardrobe/part.h"

namespace throng::test {

/// A piece of skin or a garment as a body wears it.
struct WornCloth {
  std::string name;
  int layer = 0;  ///< Skin, shoes, bottoms, tops, outer clothes.
  mannequin::Mesh mesh;
  std::vector<bool> border;  ///< Per vertex, whether the surface ends there.
  std::vector<bool> inside;  ///< Per vertex, whether it faces the body: a lining.

  [[nodiscard]] glm::dvec3 at_rest(std::size_t vertex) const { return mesh.vertices[vertex].position; }
};

WornCloth worn_part(const wardrobe::Part& part, wardrobe::Body body);
/// A piece of a body's skin.
WornCloth worn_skin(wardrobe::Slot piece, wardrobe::Body body);

/// Holds the joints at a moment of a clip, with the root at the origin.
struct ClipMoment {
  std::string clip;
  mannequin::WorldPose pose;
};
const std::vector<ClipMoment>& clip_moments();

using Corners = std::array<glm::dvec3, 3>;
/// The shares of a triangle's corners at its point that is nearest to a place.
glm::dvec3 nearest_shares(glm::dvec3 place, const Corners& triangle);
/// Returns where the vertices of a mesh are in a pose.
std::vector<glm::dvec3> places_of(const mannequin::Mesh& mesh, const mannequin::WorldPose& pose);

/// A range of heights at rest, metres.
struct Heights {
  double low = 0, high = 10;
};

/// Finds the vertices of an inner part that lie below an outer one at rest, and how far they come out of it.
class CoveredCloth {
 public:
  /// Vertices outside the heights do not count.
  CoveredCloth(const WornCloth& inner, const WornCloth& outer, Heights heights = {});
  [[nodiscard]] bool empty() const { return below_.empty(); }
  /// Returns by how many metres the farthest one stands out of the outer part and is seen.
  [[nodiscard]] double deepest(const mannequin::WorldPose& pose) const;
  /// Returns the place at rest of what `deepest` found last.
  [[nodiscard]] glm::dvec3 place() const { return place_; }

 private:
  struct Below {
    std::size_t vertex;
    std::vector<std::size_t> triangles;  ///< Of the outer part, nearby and of the same limb.
  };
  const WornCloth& inner_;
  const WornCloth& outer_;
  std::vector<Below> below_;
  mutable glm::dvec3 place_{0};
};

}  // namespace throng::test
