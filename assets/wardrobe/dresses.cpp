#include <glm/geometric.hpp>

#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/sewing.h"
#include "assets/wardrobe/tailor.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

/// The inside of a dress below the hips: rows as the dress has them, a little narrower, from the hem up.
void line_dress(Cage& cage, const TopCut& cut, double top) {
  Row upper;
  std::vector<Row> rows;
  for (const TrunkRow& row : cut.rows) {
    if (row.height > top) break;
    TrunkRow in = row;
    const double less = rows.empty() ? 0 : 0.012;
    in.half_width -= less;
    in.front -= less;
    in.back += less;
    rows.push_back(add_trunk_row(cage, in));
  }
  for (std::size_t r = 0; r + 1 < rows.size(); ++r) join(cage, rows[r + 1], rows[r], false, cut.region, 0.5, 0);
}

void bind_neck(Cage& cage, const Row& neck) {
  const Row inner = moved(cage, neck, [](dvec3 p) { return dvec3(-p.x * 0.10, -0.008, p.z > -0.02 ? -0.009 : 0.009); });
  join(cage, neck, inner, false, Region::shirt, 0.82, 1);
}

}  // namespace

Skin make_summer_dress() {
  Cage half;
  TopCut cut{.rows = {{0.540, 0.214, 0.150, -0.168},
                      {0.660, 0.202, 0.136, -0.158},
                      {0.790, 0.190, 0.120, -0.146},
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
             .armhole_in = 0.022};
  const TopBorders top = add_top(half, cut);
  line_dress(half, cut, 0.80);
  bind_neck(half, top.neck);
  hem_armhole(half, top.armhole, Region::shirt, 1);
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0020);
  return cloth;
}

Skin make_evening_dress() {
  Cage half;
  TopCut cut{.rows = {{0.130, 0.236, 0.160, -0.214},
                      {0.260, 0.214, 0.140, -0.180},
                      {0.420, 0.196, 0.122, -0.148},
                      {0.600, 0.186, 0.110, -0.124},
                      {0.790, 0.187, 0.108, -0.132},
                      {0.900, 0.174, 0.107, -0.141},
                      {0.985, 0.160, 0.104, -0.124},
                      {1.075, 0.148, 0.101, -0.102},
                      {1.170, 0.153, 0.107, -0.107},
                      {1.280, 0.164, 0.117, -0.122, 0.006, 0, 0.84}},
             .ease = 0.009,
             .neck = {1.500, 0.098, 0.044, -0.092, 0.030, 0.0, 0.9},
             .slope_width = 0.122,
             .scoop = 0.110,
             .scoop_back = 0.060,
             .armhole_in = 0.030};
  const TopBorders top = add_top(half, cut);
  line_dress(half, cut, 0.62);
  bind_neck(half, top.neck);
  hem_armhole(half, top.armhole, Region::shirt, 0);
  return mirrored_surface(half);
}

}  // namespace throng::wardrobe
