#include <cstddef>

#include "assets/mannequin/body.h"
#include "assets/mannequin/body_parts.h"
#include "assets/mannequin/glb.h"
#include "assets/mannequin/occlusion.h"
#include "assets/mannequin/surface.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

Skin smooth_skin(const Surface& surface) {
  Skin skin = skin_of(surface);
  compute_normals(skin);
  std::vector<dvec3> positions;
  std::vector<dvec3> normals;
  for (const SkinPoint& point : skin.points) {
    positions.push_back(point.position);
    normals.push_back(point.normal);
  }
  const std::vector<double> openness = bake_openness(positions, normals, triangles_of(skin));
  for (std::size_t p = 0; p < skin.points.size(); ++p) skin.points[p].openness = openness[p];
  return skin;
}

}  // namespace

Mesh make_body() {
  constexpr int fitting_rounds = 4;
  return make_mesh(smooth_skin(subdivide(fit(mirrored(build_half_body()), fitting_rounds))));
}

std::vector<std::byte> make_mannequin() { return write_glb(make_body(), make_clips()); }

}  // namespace throng::mannequin
