#include "assets/places/mesh_builder.h"

#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "assets/places/arithmetic.h"

namespace throng::places {

Paint shaded(Paint paint, double factor) {
  paint.color *= factor;
  return paint;
}

void MeshBuilder::add(Face face) {
  for (std::size_t i = 0; i < face.count; ++i) {
    Corner& corner = face.corners[i];
    corner.position = dvec3(place * glm::dvec4(corner.position, 1));
    if (corner.normal != dvec3(0)) corner.normal = glm::normalize(glm::dmat3(place) * corner.normal);
  }
  if (glm::determinant(glm::dmat3(place)) < 0) {
    for (std::size_t i = 0; i < face.count / 2; ++i) std::swap(face.corners[i], face.corners[face.count - 1 - i]);
  }
  faces.push_back(face);
}

void MeshBuilder::triangle(dvec3 a, dvec3 b, dvec3 c, const Paint& paint, int smooth) {
  add({{Corner{a, paint}, Corner{b, paint}, Corner{c, paint}, Corner{}}, 3, smooth});
}

void MeshBuilder::quad(dvec3 a, dvec3 b, dvec3 c, dvec3 d, const Paint& paint, int smooth) {
  add({{Corner{a, paint}, Corner{b, paint}, Corner{c, paint}, Corner{d, paint}}, 4, smooth});
}

Moved::Moved(MeshBuilder& builder, dvec3 by, double turns, dvec3 stretch) : builder_(builder), before_(builder.place) {
  const double c = cosine(turns);
  const double s = sine(turns);
  builder.place =
      builder.place * glm::dmat4(glm::dvec4(c * stretch.x, 0, -s * stretch.x, 0), glm::dvec4(0, stretch.y, 0, 0),
                                 glm::dvec4(s * stretch.z, 0, c * stretch.z, 0), glm::dvec4(by, 1));
}

}  // namespace throng::places
