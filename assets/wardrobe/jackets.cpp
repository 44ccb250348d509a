#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/sewing.h"
#include "assets/wardrobe/tailor.h"

namespace throng::wardrobe {
namespace {

using glm::dvec2;
using glm::dvec3;
using mannequin::Skin;

/// Half the opening of a front that is closed up to `button` and opens to `wide` at the neck.
std::function<double(double)> opening(double button, double wide, double below, double hem) {
  return [=](double height) {
    if (height > button) return 0.004 + (wide - 0.004) * std::min(1.0, (height - button) / (1.47 - button));
    return 0.004 + (below - 0.004) * std::max(0.0, (button - 0.16 - height) / (button - 0.16 - hem));
  };
}

/// Half an opening that is nearly the same everywhere.
std::function<double(double)> hanging_open(double low, double high) {
  return [=](double height) { return low + (high - low) * rise(0.9, 1.45, height); };
}

std::vector<SleeveRow> jacket_sleeve(double room, double end) {
  return {{0.070, 0.066 + room, 0.065 + room, 0, -0.003, 0, 1, true},
          {0.125, 0.066 + room, 0.064 + room, 0, 0},
          {0.195, 0.063 + room, 0.061 + room, 0, 0.001},
          {0.275, 0.057 + room, 0.055 + room, 0, 0.002},
          {0.305, 0.054 + room, 0.052 + room, 0, 0.002},
          {0.400, 0.049 + room, 0.047 + room, 0.001, 0.001},
          {end - 0.016, 0.044 + room, 0.041 + room, 0.001, 0, 0, 0.98},
          {end, 0.044 + room, 0.041 + room, 0.001, 0, 0, 0.98}};
}

/// Turns the two front edges in and closes the neck's edge.
void finish_neck(Cage& cage, const Row& neck, Region region) {
  const Row inner = moved(cage, neck, [](dvec3 p) { return dvec3(-p.x * 0.10, -0.010, p.z > -0.02 ? -0.008 : 0.008); });
  join(cage, neck, inner, false, region, 0.7, 0);
}

/// A collar that lies on the lapels and stands up behind.
std::vector<CollarPoint> jacket_collar(double angle) {
  const double front = rise(90, 30, angle);
  return {{0.020, -0.010},
          {0.026, 0.024 - 0.014 * front},
          {0.034 + 0.006 * front, 0.023 - 0.016 * front},
          {0.048 + 0.010 * front, -0.008 - 0.022 * front},
          {0.040 + 0.010 * front, -0.013 - 0.022 * front}};
}

/// A lapel along the opening, from the button to the collar: its inner edge follows the front, its outer one has a
/// notch. `width` is its width at the notch.
Piece lapel(const std::function<double(double)>& gap, double button, double top, double width, double lift) {
  Piece piece;
  piece.region = Region::outer;
  piece.paint = 0.94;
  piece.lift = lift;
  piece.both_sides = true;
  constexpr int steps = 6;
  for (int s = 0; s <= steps; ++s) {
    const double share = static_cast<double>(s) / steps;
    const double height = button + (top - button) * share;
    const double inner = gap(height) + 0.003;
    const double outer = inner + width * std::min(1.0, 0.10 + 1.05 * share) * (s == steps ? 0.72 : 1);
    piece.rows.push_back(
        {{inner, height}, {0.5 * (inner + outer), height}, {outer, height + (s == steps ? -0.012 : 0)}});
  }
  return piece;
}

void pocket_flaps(Skin& cloth, double height, double inner, double width) {
  sew_on(cloth, {.rows = rectangle({inner, height - 0.040}, {inner + width, height}, 1, 3),
                 .region = Region::outer,
                 .lift = 0.005,
                 .both_sides = true});
}

}  // namespace

Skin make_suit_jacket() {
  Cage half;
  const auto gap = opening(1.110, 0.062, 0.045, 0.80);
  const TopBorders top = add_top(half, {.region = Region::outer,
                                        .rows = {{0.800, 0.200, 0.134, -0.160, -0.010, 0},
                                                 {0.870, 0.195, 0.128, -0.165},
                                                 {0.930, 0.187, 0.124, -0.158},
                                                 {0.985, 0.179, 0.120, -0.150},
                                                 {1.050, 0.169, 0.121, -0.132},
                                                 {1.170, 0.168, 0.124, -0.126},
                                                 {1.280, 0.177, 0.132, -0.137, 0.006, 0, 0.84}},
                                        .ease = 0.018,
                                        .shoulder = 0.006,
                                        .neck = {1.520, 0.086, 0.062, -0.100, 0.036, 0.0, 1.0},
                                        .gap = gap});
  finish_neck(half, top.neck, Region::outer);
  add_collar(half, Region::outer, 34, 0, jacket_collar);
  add_sleeve(half, top.armhole, Region::outer, jacket_sleeve(0.002, 0.520));
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0014);
  sew_on(cloth, lapel(gap, 1.110, 1.440, 0.068, 0.007));
  pocket_flaps(cloth, 0.935, 0.072, 0.078);
  sew_on(
      cloth,
      {.rows = rectangle({0.078, 1.290}, {0.128, 1.304}, 1, 2), .region = Region::outer, .lift = 0.004, .paint = 0.8});
  add_buttons(cloth, Region::outer, {0.020, 1.095}, {0.020, 0.990}, 2, 0.009, 0.003, 0.4, 0);
  return cloth;
}

Skin make_waistcoat() {
  Cage half;
  const auto gap = opening(1.230, 0.060, 0.040, 0.955);
  const TopBorders top = add_top(half, {.region = Region::outer,
                                        .rows = {{0.948, 0.181, 0.124, -0.152, 0.024, 0},
                                                 {0.985, 0.178, 0.122, -0.146, 0.010, 0},
                                                 {1.075, 0.167, 0.121, -0.121},
                                                 {1.170, 0.167, 0.124, -0.124},
                                                 {1.280, 0.177, 0.132, -0.136, 0.006, 0, 0.84}},
                                        .ease = 0.019,
                                        .neck = {1.514, 0.078, 0.054, -0.090, 0.036, 0.0, 1.0},
                                        .armhole_in = 0.026,
                                        .gap = gap});
  finish_neck(half, top.neck, Region::outer);
  hem_armhole(half, top.armhole, Region::outer);
  Skin cloth = mirrored_surface(half);
  add_buttons(cloth, Region::outer, {0.018, 1.215}, {0.018, 1.010}, 5, 0.007, 0.003, 0.45, 0);
  sew_on(cloth, {.rows = rectangle({0.068, 1.030}, {0.124, 1.046}, 1, 2),
                 .region = Region::outer,
                 .lift = 0.004,
                 .paint = 0.85,
                 .both_sides = true});
  return cloth;
}

Skin make_coat() {
  Cage half;
  const auto gap = opening(1.200, 0.066, 0.016, 0.50);
  const TopCut cut{.region = Region::outer,
                   .rows = {{0.470, 0.234, 0.138, -0.206},
                            {0.600, 0.216, 0.125, -0.190},
                            {0.700, 0.203, 0.118, -0.178},
                            {0.790, 0.198, 0.118, -0.176},
                            {0.850, 0.195, 0.129, -0.176},
                            {0.920, 0.192, 0.129, -0.168},
                            {0.985, 0.185, 0.129, -0.154},
                            {1.050, 0.172, 0.128, -0.138},
                            {1.170, 0.169, 0.131, -0.132},
                            {1.280, 0.182, 0.137, -0.142, 0.006, 0, 0.84}},
                   .ease = 0.023,
                   .shoulder = 0.006,
                   .neck = {1.524, 0.089, 0.065, -0.103, 0.036, 0.0, 1.0},
                   .hem_depth = 0.05,
                   .gap = gap,
                   .dense = true};
  const TopBorders top = add_top(half, cut);
  line_below(half, cut, 0.75);
  finish_neck(half, top.neck, Region::outer);
  add_collar(half, Region::outer, 34, 1, [](double angle) {
    std::vector<CollarPoint> points = jacket_collar(angle);
    for (std::size_t p = 0; p < points.size(); ++p) points[p].out += p < 2 ? 0.003 : 0.010;
    points[1].up += 0.010;
    points[2].up += 0.010;
    return points;
  });
  add_sleeve(half, top.armhole, Region::outer, jacket_sleeve(0.006, 0.530));
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0022);
  Piece wide = lapel(gap, 1.200, 1.430, 0.078, 0.008);
  wide.trim = 1;
  sew_on(cloth, wide);
  pocket_flaps(cloth, 0.900, 0.085, 0.080);
  add_buttons(cloth, Region::outer, {0.030, 1.185}, {0.032, 0.860}, 4, 0.012, 0.004, 0.4, 0);
  return cloth;
}

Skin make_cardigan() {
  Cage half;
  const auto gap = hanging_open(0.062, 0.044);
  const TopBorders top = add_top(half, {.region = Region::outer,
                                        .rows = {{0.850, 0.190, 0.126, -0.160, 0.004},
                                                 {0.885, 0.191, 0.128, -0.164, 0.004},
                                                 {0.930, 0.186, 0.126, -0.158},
                                                 {0.985, 0.180, 0.124, -0.147},
                                                 {1.050, 0.172, 0.123, -0.130},
                                                 {1.170, 0.168, 0.124, -0.125},
                                                 {1.280, 0.175, 0.130, -0.135, 0.006, 0, 0.84}},
                                        .ease = 0.016,
                                        .neck = {1.517, 0.078, 0.054, -0.092, 0.034, 0.0, 1.0},
                                        .gap = gap,
                                        .hem_trim = 1});
  finish_neck(half, top.neck, Region::outer);
  std::vector<SleeveRow> sleeve = jacket_sleeve(0.003, 0.515);
  sleeve.back() = {0.505, 0.040, 0.036, 0, 0, 1, 0.92};
  sleeve.push_back({0.540, 0.038, 0.033, 0, 0, 1});
  add_sleeve(half, top.armhole, Region::outer, sleeve);
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0026);
  Piece band;
  band.region = Region::outer;
  band.lift = 0.004;
  band.trim = 1;
  band.both_sides = true;
  for (int s = 0; s <= 8; ++s) {
    const double height = 0.853 + (1.462 - 0.853) * s / 8.0;
    band.rows.push_back({{gap(height) + 0.004, height}, {gap(height) + 0.032, height}});
  }
  sew_on(cloth, band);
  return cloth;
}

Skin make_hi_vis() {
  Cage half;
  const auto gap = opening(1.360, 0.052, 0.004, 0.88);
  TopCut cut{.region = Region::outer,
             .rows = {{0.885, 0.186, 0.124, -0.164},
                      {0.930, 0.185, 0.125, -0.160},
                      {0.985, 0.184, 0.127, -0.152},
                      {1.035, 0.180, 0.127, -0.142},
                      {1.110, 0.170, 0.128, -0.134},
                      {1.160, 0.168, 0.130, -0.134},
                      {1.280, 0.180, 0.135, -0.141, 0.006, 0, 0.84}},
             .ease = 0.020,
             .shoulder = 0.004,
             .neck = {1.517, 0.084, 0.058, -0.096, 0.036, 0.0, 1.0},
             .armhole_in = 0.008,
             .gap = gap};
  const std::size_t first = half.faces.size();
  const TopBorders top = add_top(half, cut);
  // Two bands that shine.
  for (std::size_t f = first; f < half.faces.size(); ++f) {
    double low = 9, high = 0;
    for (const std::size_t c : half.faces[f].corners) {
      low = std::min(low, half.vertices[c].position.y);
      high = std::max(high, half.vertices[c].position.y);
    }
    if ((low > 0.98 && high < 1.04) || (low > 1.105 && high < 1.165)) half.faces[f].notes.trim = 1;
  }
  finish_neck(half, top.neck, Region::outer);
  hem_armhole(half, top.armhole, Region::outer);
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0020);
  for (const LaidFrom from : {LaidFrom::front, LaidFrom::back}) {
    sew_on(cloth, {.rows = rectangle({0.084, 1.163}, {0.126, 1.440}, 8, 2),
                   .from = from,
                   .region = Region::outer,
                   .lift = 0.0045,
                   .trim = 1,
                   .both_sides = true});
  }
  return cloth;
}

Skin make_rain_jacket() {
  Cage half;
  const TopBorders top = add_top(half, {.rows = {{0.790, 0.200, 0.130, -0.180, -0.006, 0.014},
                                                 {0.860, 0.198, 0.136, -0.174},
                                                 {0.925, 0.193, 0.132, -0.162},
                                                 {0.985, 0.181, 0.129, -0.150},
                                                 {1.050, 0.168, 0.128, -0.138},
                                                 {1.170, 0.163, 0.128, -0.130},
                                                 {1.280, 0.178, 0.131, -0.137, 0.006, 0, 0.84}},
                                        .ease = 0.018,
                                        .shoulder = 0.004,
                                        .hem_depth = 0.03});
  add_collar(half, Region::shirt, 4, 1, [](double angle) -> std::vector<CollarPoint> {
    const double back = rise(50, 150, angle);
    return {{0.002, -0.010},
            {0.008, 0.036 + 0.010 * back},
            {0.018 + 0.016 * back, 0.040 + 0.012 * back},
            {0.024 + 0.050 * back, 0.006 - 0.020 * back},
            {0.022 + 0.050 * back, -0.010 - 0.120 * back},
            {0.014 + 0.026 * back, -0.014 - 0.140 * back}};
  });
  std::vector<SleeveRow> sleeve = jacket_sleeve(0.003, 0.535);
  sleeve[6].trim = sleeve[7].trim = 1;
  add_sleeve(half, top.armhole, Region::shirt, sleeve);
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0030);
  sew_on(cloth, {.rows = rectangle({-0.020, 0.800}, {0.020, 1.462}, 8, 1), .lift = 0.005, .paint = 0.96});
  add_buttons(cloth, Region::shirt, {0, 1.430}, {0, 0.86}, 5, 0.007, 0.0065, 0.9, 1);
  sew_on(cloth, {.rows = {{{0.070, 0.905}, {0.150, 0.905}}, {{0.080, 0.950}, {0.158, 0.950}}},
                 .lift = 0.005,
                 .both_sides = true});
  return cloth;
}

}  // namespace throng::wardrobe
