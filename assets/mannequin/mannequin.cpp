#include <algorithm>
#include <array>
#include <string_view>

#include <glm/common.hpp>

#include "assets/mannequin/body.h"
#include "assets/mannequin/body_parts.h"
#include "assets/mannequin/glb.h"
#include "assets/mannequin/occlusion.h"
#include "assets/mannequin/surface.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

dvec3 above_ground(dvec3 place) { return {place.x, std::max(place.y, 0.0), place.z}; }

Skin smooth_skin(const Surface& surface) {
  Skin skin;
  for (const CageVertex& vertex : surface.vertices) {
    const dvec3 stepped = glm::round(above_ground(vertex.position) / position_step) * position_step + dvec3(0);
    skin.points.push_back({.position = stepped, .weights = vertex.weights});
  }
  for (const Quad& quad : surface.quads) {
    skin.faces.push_back({{quad.corners.begin(), quad.corners.end()}, quad.region, std::vector<dvec3>(4, quad.paint)});
  }
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

/// The cage itself, its points where subdivision put them: every second point of the smooth skin.
Skin cage_skin(const Cage& cage, const Skin& smooth) {
  Skin skin;
  skin.points.assign(smooth.points.begin(), smooth.points.begin() + static_cast<std::ptrdiff_t>(cage.vertices.size()));
  for (const CageFace& face : cage.faces) skin.faces.push_back({face.corners, face.region, face.paint});
  return skin;
}

}  // namespace

bool kept_at_level(std::size_t joint, std::size_t level) {
  constexpr std::array<std::string_view, 15> coarse{
      "root",       "hips",        "spine",     "chest",   "upper_chest", "shoulder.L", "upper_arm.L", "forearm.L",
      "shoulder.R", "upper_arm.R", "forearm.R", "thigh.L", "shin.L",      "thigh.R",    "shin.R"};
  constexpr std::array<std::string_view, 11> medium{"neck",     "hand.L", "index.1.L", "middle.1.L",
                                                    "ring.1.L", "hand.R", "index.1.R", "middle.1.R",
                                                    "ring.1.R", "foot.L", "foot.R"};
  const std::string_view name = skeleton()[joint].name;
  const bool in_coarse = std::find(coarse.begin(), coarse.end(), name) != coarse.end();
  const bool in_medium = std::find(medium.begin(), medium.end(), name) != medium.end();
  return level == 0 || in_coarse || (level == 1 && in_medium);
}

Body make_body() {
  constexpr int fitting_rounds = 4;
  constexpr std::size_t coarsest_level = 2;
  const Cage cage = fit(mirrored(build_half_body()), fitting_rounds);
  const Skin smooth = smooth_skin(subdivide(cage));
  const std::array<Skin, mesh_lod_count> coarser{cage_skin(cage, smooth), make_medium_skin(smooth),
                                                 make_smallest_skin(smooth)};
  Body body{make_mesh(smooth, [](std::size_t) { return true; }), {}};
  for (std::size_t lod = 0; lod < mesh_lod_count; ++lod) {
    const std::size_t level = std::min(lod + 1, coarsest_level);
    body.lods[lod] = make_mesh(coarser[lod], [level](std::size_t joint) { return kept_at_level(joint, level); });
  }
  return body;
}

std::vector<std::byte> make_mannequin() { return write_glb(make_body(), make_clips()); }

}  // namespace throng::mannequin
