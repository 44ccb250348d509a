#pragma once

#include <glm/vec3.hpp>

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

/// Says how points of a surface follow the build of a body. The shader moves a point along its normal, so what faces
/// another way than the skin below it, as hems and linings do, would part from what it is sewn to.
class BuildShares {
 public:
  /// `surface` lies on the man and has normals.
  explicit BuildShares(const mannequin::Skin& surface);

  /// Gives what faces along the skin, such as the inside of hems, the normals of the skin below.
  void turn_normals(mannequin::Skin& surface) const;
  /// Sets the shares of vertices that were made of the surface.
  void set_shares(mannequin::Mesh& mesh) const;

 private:
  struct Below {
    glm::dvec3 normal{0};  ///< Of the man's skin; none where the surface faces as the skin does, or the other way.
    glm::dvec3 shares{0};
  };
  std::vector<Below> below_;  ///< [point]
};

}  // namespace throng::wardrobe
