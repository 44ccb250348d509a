#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "assets/making/triangle.h"
#include "assets/mannequin/mesh.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

/// A place on the man's skin.
using SkinPlace = making::PlaceOnTriangle;

/// Says how points of a surface follow the build of a body. The shader moves a point along its normal, so what faces
/// another way than the skin below it, as hems and linings do, would part from what it is sewn to.
class BuildShares {
 public:
  /// `surface` lies on the man and has normals.
  explicit BuildShares(const mannequin::Skin& surface);

  /// Gives what faces along the skin, such as the inside of hems, the normals of a body's skin below.
  void turn_normals(mannequin::Skin& surface, Body body) const;
  /// Sets the shares of vertices that were made of the surface.
  void set_shares(mannequin::Mesh& mesh) const;

 private:
  struct Below {
    SkinPlace place;
    bool faces_along = false;  ///< The surface faces neither as the skin does nor the other way.
    glm::dvec3 shares{0};
  };
  std::vector<Below> below_;  ///< [point]
};

}  // namespace throng::wardrobe
