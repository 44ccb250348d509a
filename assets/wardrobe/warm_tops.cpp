#include <algorithm>
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

std::vector<SleeveRow> knitted_sleeve() {
  return {{0.070, 0.063, 0.062, 0, -0.004, 0, 1, true},
          {0.172, 0.056, 0.056, 0, 0.002},
          {0.272, 0.051, 0.050, 0, 0.003},
          {0.300, 0.051, 0.050, 0, 0.003},
          {0.400, 0.048, 0.046, 0.002, 0.002},
          {0.486, 0.045, 0.042, 0.001, 0.002},
          {0.500, 0.035, 0.031, 0, 0, 1, 0.9},
          {0.545, 0.034, 0.029, 0, 0, 1}};
}

/// A soft roll around the neck.
std::vector<CollarPoint> knitted_collar(double /*angle*/) {
  return {{-0.004, -0.006}, {0.001, 0.020}, {0.010, 0.020}, {0.018, -0.004}};
}

/// A hood that lies on the back: small in front, large behind.
std::vector<CollarPoint> lying_hood(double angle) {
  const double back = rise(40, 150, angle);
  return {{-0.002, -0.008},
          {0.002, 0.026 + 0.016 * back},
          {0.014 + 0.028 * back, 0.034 + 0.020 * back},
          {0.028 + 0.062 * back, 0.012 - 0.022 * back},
          {0.026 + 0.062 * back, -0.006 - 0.095 * back},
          {0.016 + 0.030 * back, -0.016 - 0.115 * back}};
}

}  // namespace

Skin make_jumper() {
  Cage half;
  const TopBorders top = add_top(half, {.rows = {{0.928, 0.174, 0.112, -0.146, 0.004},
                                                 {0.970, 0.174, 0.112, -0.146, 0.004},
                                                 {0.984, 0.181, 0.121, -0.151, 0.004},
                                                 {1.065, 0.162, 0.120, -0.126},
                                                 {1.170, 0.159, 0.121, -0.120},
                                                 {1.280, 0.171, 0.126, -0.131, 0.006, 0, 0.84}},
                                        .ease = 0.011,
                                        .hem_trim = 1});
  add_collar(half, Region::shirt, 0, 1, knitted_collar);
  add_sleeve(half, top.armhole, Region::shirt, knitted_sleeve());
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0026);
  return cloth;
}

Skin make_hoodie() {
  Cage half;
  const TopBorders top = add_top(half, {.rows = {{0.922, 0.175, 0.114, -0.148, 0.004},
                                                 {0.968, 0.175, 0.114, -0.148, 0.004},
                                                 {0.984, 0.188, 0.132, -0.160, 0.004},
                                                 {1.065, 0.165, 0.134, -0.140},
                                                 {1.170, 0.161, 0.130, -0.128},
                                                 {1.280, 0.174, 0.130, -0.136, 0.006, 0, 0.84}},
                                        .ease = 0.015,
                                        .hem_trim = 1});
  add_collar(half, Region::shirt, 3, 0, lying_hood);
  std::vector<SleeveRow> sleeve = knitted_sleeve();
  for (SleeveRow& row : sleeve) {
    if (row.along > 0.49) continue;
    row.half_width += 0.006;
    row.half_height += 0.005;
    row.out += 0.003;
    row.trim = row.along > 0.08 ? 1 : 0;
  }
  add_sleeve(half, top.armhole, Region::shirt, sleeve);
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0032);
  sew_on(cloth, {.rows = {{{-0.105, 0.972}, {-0.05, 0.970}, {0, 0.970}, {0.05, 0.970}, {0.105, 0.972}},
                          {{-0.105, 1.010}, {-0.05, 1.02}, {0, 1.02}, {0.05, 1.02}, {0.105, 1.010}},
                          {{-0.062, 1.090}, {-0.03, 1.094}, {0, 1.094}, {0.03, 1.094}, {0.062, 1.090}}},
                 .lift = 0.007});
  for (const double x : {-0.024, 0.024}) {
    sew_on(cloth,
           {.rows = rectangle({x - 0.003, 1.335}, {x + 0.003, 1.475}, 6, 1), .lift = 0.005, .trim = 1, .paint = 0.95});
  }
  return cloth;
}

Skin make_puffer() {
  Cage half;
  std::vector<TrunkRow> rows;
  constexpr int rolls = 5;
  // Rolls of down between seams.
  for (int r = 0; r <= 2 * rolls; ++r) {
    const double height = 0.890 + 0.390 * r / (2.0 * rolls);
    const double fat = r % 2 == 0 ? 0.012 : 0.036;
    TrunkRow row = trunk_row(std::max(height, 0.96), fat);
    row.height = height;
    row.half_width -= 0.85 * fat;  // arms hang beside it
    row.front += 0.010;
    row.back -= 0.004;
    rows.push_back(row);
  }
  TopBorders top = add_top(half, {.rows = rows, .ease = 0.026, .hem_depth = 0.018});
  add_collar(half, Region::shirt, 2, 0, [](double) -> std::vector<CollarPoint> {
    return {{0.000, -0.010}, {0.004, 0.030}, {0.012, 0.040}, {0.024, 0.030}, {0.026, 0.012}, {0.016, -0.006}};
  });
  std::vector<SleeveRow> sleeve{{0.050, 0.068, 0.066, 0, 0.0, 0, 1, true}};
  constexpr int sleeve_rolls = 5;
  for (int r = 1; r <= 2 * sleeve_rolls; ++r) {
    const double along = 0.050 + 0.455 * r / (2.0 * sleeve_rolls);
    const double slim = 1 - 0.22 * r / (2.0 * sleeve_rolls);
    const double size = (r % 2 == 0 ? 0.054 : 0.073) * slim;
    sleeve.push_back({along, size, size, 0, r % 2 == 0 ? 0.004 : 0.010, 0, 1});
  }
  sleeve.push_back({0.540, 0.036, 0.032, 0, 0, 1});
  add_sleeve(half, top.armhole, Region::shirt, sleeve);
  Skin cloth = mirrored_surface(half);
  for (mannequin::SkinFace& face : cloth.faces) {
    for (std::size_t c = 0; c < face.corners.size(); ++c) {
      const dvec3 at = cloth.points[face.corners[c]].position;
      const double seam = std::abs(std::remainder((at.y - 0.890) / 0.078, 1.0));
      if (std::abs(at.x) < 0.17 && at.y < 1.27) face.paint[c] *= 0.72 + 0.28 * rise(0.05, 0.30, seam);
    }
  }
  sew_on(cloth, {.rows = rectangle({-0.007, 0.905}, {0.007, 1.455}, 11, 1), .lift = 0.006, .trim = 1, .paint = 0.8});
  return cloth;
}

}  // namespace throng::wardrobe
