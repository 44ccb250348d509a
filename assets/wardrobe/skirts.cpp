#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/sewing.h"
#include "assets/wardrobe/tailor.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

struct SkirtRow {
  double height, half_width, front, back;
};

constexpr double skirt_squareness = 0.9;
/// Degrees of a plain skirt's columns, closer where one leg passes the other.
constexpr std::array<double, 9> dense_columns{0, 15, 30, 60, 90, 120, 150, 165, 180};

Row add_skirt_row(Cage& cage, const SkirtRow& row, std::size_t columns, double pleat) {
  Row made;
  for (std::size_t c = 0; c < columns; ++c) {
    const double angle = columns == dense_columns.size()
                             ? std::numbers::pi * dense_columns[c] / 180
                             : std::numbers::pi * static_cast<double>(c) / static_cast<double>(columns - 1);
    const bool middle = c == 0 || c + 1 == columns;
    const double out = c % 2 == 0 ? pleat : -pleat;
    const double sine = middle ? 0 : std::pow(std::sin(angle), skirt_squareness);
    const double cosine = std::abs(std::cos(angle)) < 1e-9
                              ? 0
                              : std::copysign(std::pow(std::abs(std::cos(angle)), skirt_squareness), std::cos(angle));
    const dvec3 place((row.half_width + out) * sine, row.height,
                      0.5 * (row.front + row.back) + (0.5 * (row.front - row.back) + out) * cosine);
    made.push_back(cage.add(place, place.y > 0.975 ? weights_at(place, {Slot::torso}) : hanging_weights(place)));
  }
  return made;
}

/// The inside of a skirt, from the hem up, coarser than the outside.
void line_skirt(Cage& cage, const std::vector<SkirtRow>& rows, std::size_t columns, double top, double trim) {
  Row upper;
  for (std::size_t r = rows.size(); r-- > 0;) {
    if (rows[r].height > top) break;
    SkirtRow row = rows[r];
    const double in = r + 1 == rows.size() ? 0 : 0.012;
    row.half_width -= in;
    row.front -= in;
    row.back += in;
    const Row made = add_skirt_row(cage, row, columns, 0);
    if (!upper.empty()) join(cage, made, upper, false, Region::trousers, 0.5, trim);
    upper = made;
  }
}

/// A skirt of rows from the waist down; `pleat` grows from nothing at the first row to its whole at the hem.
void add_skirt(Cage& cage, const std::vector<SkirtRow>& rows, std::size_t columns, double pleat, double hem_trim) {
  cage.notes.chart = mannequin::Chart::around_body;
  Row upper;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const double share = rows[r].height > 0.90 ? 0 : static_cast<double>(r) / static_cast<double>(rows.size() - 1);
    const Row row = add_skirt_row(cage, rows[r], columns, pleat * share);
    if (r == 0) {
      const Row inside = moved(cage, row, [](dvec3 p) { return dvec3(-0.07 * p.x, -0.014, -0.08 * p.z); });
      join(cage, row, inside, false, Region::trousers, 0.75, 1);
    } else {
      const bool last = r + 1 == rows.size();
      join(cage, row, upper, false, Region::trousers, 1, r == 1 || last ? (last ? hem_trim : 1) : 0);
    }
    upper = row;
  }
  line_skirt(cage, rows, columns, 0.80, 0);
}

}  // namespace

Skin make_knee_skirt() {
  Cage half;
  add_skirt(half,
            {{1.000, 0.160, 0.102, -0.114},
             {0.965, 0.168, 0.104, -0.130},
             {0.900, 0.174, 0.108, -0.142},
             {0.845, 0.181, 0.110, -0.141},
             {0.790, 0.185, 0.104, -0.134},
             {0.680, 0.186, 0.098, -0.122},
             {0.560, 0.184, 0.100, -0.118},
             {0.455, 0.182, 0.104, -0.120}},
            dense_columns.size(), 0, 0);
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0015);
  return cloth;
}

Skin make_long_skirt() {
  Cage half;
  add_skirt(half,
            {{1.000, 0.160, 0.102, -0.114},
             {0.965, 0.168, 0.104, -0.130},
             {0.900, 0.174, 0.108, -0.142},
             {0.845, 0.181, 0.109, -0.145},
             {0.750, 0.187, 0.105, -0.144},
             {0.620, 0.193, 0.107, -0.148},
             {0.480, 0.210, 0.120, -0.162},
             {0.330, 0.234, 0.158, -0.186},
             {0.220, 0.252, 0.172, -0.204},
             {0.175, 0.258, 0.176, -0.208}},
            11, 0.010, 1);
  return mirrored_surface(half);
}

Skin make_pleated_skirt() {
  Cage half;
  add_skirt(half,
            {{1.000, 0.160, 0.102, -0.114},
             {0.965, 0.168, 0.104, -0.130},
             {0.905, 0.174, 0.108, -0.142},
             {0.850, 0.183, 0.114, -0.147},
             {0.800, 0.187, 0.106, -0.144},
             {0.680, 0.195, 0.107, -0.152},
             {0.580, 0.204, 0.116, -0.162}},
            15, 0.012, 0);
  Skin cloth = mirrored_surface(half);
  return cloth;
}

}  // namespace throng::wardrobe
