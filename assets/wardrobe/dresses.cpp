#include <glm/geometric.hpp>

#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/sewing.h"
#include "assets/wardrobe/tailor.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

constexpr double bare_from = 1.335;  ///< The height below which a dress covers the skin.

void bind_neck(Cage& cage, const Row& neck) {
  const Row inner = moved(cage, neck, [](dvec3 p) { return dvec3(-p.x * 0.10, -0.008, p.z > -0.02 ? -0.009 : 0.009); });
  join(cage, neck, inner, false, Region::shirt, 0.82, 1);
}

}  // namespace

Skin make_summer_dress() {
  Cage half;
  TopCut cut{.rows = {{0.540, 0.206, 0.114, -0.158},
                      {0.660, 0.195, 0.103, -0.150},
                      {0.790, 0.186, 0.103, -0.143},
                      {0.845, 0.182, 0.109, -0.146},
                      {0.900, 0.178, 0.112, -0.146},
                      {0.985, 0.164, 0.106, -0.130},
                      {1.062, 0.151, 0.104, -0.106},
                      {1.090, 0.151, 0.104, -0.106},
                      {1.170, 0.155, 0.110, -0.109},
                      {1.280, 0.166, 0.119, -0.125, 0.006, 0, 0.84}},
             .ease = 0.009,
             .neck = {1.500, 0.092, 0.046, -0.092, 0.030, 0.0, 0.9},
             .slope_width = 0.118,
             .scoop = 0.080,
             .scoop_back = 0.040,
             .armhole_in = 0.022,
             .dense = true};
  const TopBorders top = add_top(half, cut);
  line_below(half, cut, 0.80);
  bind_neck(half, top.neck);
  hem_armhole(half, top.armhole, Region::shirt, 1);
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0020);
  append(cloth, bare_skin(Slot::torso, bare_from));
  return cloth;
}

Skin make_evening_dress() {
  Cage half;
  TopCut cut{.rows = {{0.090, 0.240, 0.164, -0.206},
                      {0.260, 0.214, 0.140, -0.180},
                      {0.420, 0.196, 0.116, -0.148},
                      {0.600, 0.185, 0.100, -0.124},
                      {0.790, 0.185, 0.104, -0.134},
                      {0.845, 0.183, 0.110, -0.144},
                      {0.900, 0.177, 0.109, -0.143},
                      {0.955, 0.174, 0.109, -0.138},
                      {1.000, 0.164, 0.107, -0.122},
                      {1.075, 0.151, 0.104, -0.105},
                      {1.170, 0.156, 0.110, -0.110},
                      {1.280, 0.168, 0.121, -0.125, 0.006, 0, 0.84}},
             .ease = 0.009,
             .neck = {1.500, 0.098, 0.044, -0.092, 0.030, 0.0, 0.9},
             .slope_width = 0.122,
             .scoop = 0.110,
             .scoop_back = 0.060,
             .armhole_in = 0.030,
             .dense = true};
  const TopBorders top = add_top(half, cut);
  line_below(half, cut, 0.62);
  bind_neck(half, top.neck);
  hem_armhole(half, top.armhole, Region::shirt, 0);
  Skin cloth = mirrored_surface(half);
  append(cloth, bare_skin(Slot::torso, bare_from));
  return cloth;
}

}  // namespace throng::wardrobe
