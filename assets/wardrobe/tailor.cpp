#include "assets/wardrobe/tailor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::bind;
using mannequin::Weights;

/// Returns the columns of a row, in degrees from the front to the back.
std::vector<double> columns_of(const TopCut& cut) {
  if (cut.dense) return {0, 15, 30, 60, 90, 120, 150, 165, 180};
  return {0, 30, 60, 90, 120, 150, 180};
}

/// The column at the side.
std::size_t side_of(const TopCut& cut) { return cut.dense ? 4 : 3; }

constexpr double fold_shade = 0.80;

/// The man's own trunk and thighs, from below.
constexpr std::array<TrunkRow, 10> man_rows{{{0.46, 0.160, 0.066, -0.066},
                                             {0.60, 0.168, 0.076, -0.078},
                                             {0.79, 0.180, 0.090, -0.106},
                                             {0.87, 0.176, 0.098, -0.126},
                                             {0.956, 0.166, 0.102, -0.132},
                                             {1.065, 0.150, 0.103, -0.104},
                                             {1.170, 0.153, 0.108, -0.108},
                                             {1.280, 0.166, 0.117, -0.122},
                                             {1.345, 0.170, 0.112, -0.130},
                                             {1.412, 0.190, 0.090, -0.126}}};

dvec3 place_on(const TrunkRow& row, double angle) {
  const double middle = 0.5 * (row.front + row.back);
  const double depth = 0.5 * (row.front - row.back);
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const double x = std::abs(sine) < 1e-9 ? 0 : std::pow(sine, row.squareness);
  const double fore = std::abs(cosine) < 1e-9 ? 0 : std::copysign(std::pow(std::abs(cosine), row.squareness), cosine);
  const double drop = fore > 0 ? row.drop_front * fore : row.drop_back * -fore;
  return {row.half_width * x, row.height - drop, middle + depth * fore};
}

Weights trunk_weights(dvec3 place) {
  return place.y < 0.975 ? hanging_weights(place) : weights_at(place, {Slot::torso, Slot::upper_arms, Slot::head});
}

/// The angle at which a row is `x` metres from the middle.
double angle_at(const TrunkRow& row, double x) {
  return std::asin(std::pow(std::clamp(x / row.half_width, 0.0, 1.0), 1 / row.squareness));
}

/// A row of a garment; with an opening it begins with a vertex that is turned in. It bends as the skin below it does,
/// which `skin` describes.
Row add_row(Cage& cage, const TopCut& cut, const TrunkRow& row, const TrunkRow& skin) {
  Row made;
  const double gap = cut.gap ? cut.gap(row.height - row.drop_front) : 0;
  const double first = cut.gap ? angle_at(row, gap) : 0;
  if (cut.gap) {
    const dvec3 edge = place_on(row, first);
    const double depth = std::min(0.012, 0.005 + 0.3 * gap);
    const dvec3 turned(edge.x + depth, edge.y, edge.z - depth);
    made.push_back(cage.add(turned, trunk_weights(place_on(skin, first))));
  }
  for (const double degrees : columns_of(cut)) {
    const double share = degrees / 180;
    // The opening moves the columns before the side only, so that the armhole stays where it is.
    const double turn = share < 0.5 ? first + (std::numbers::pi / 2 - first) * 2 * share : std::numbers::pi * share;
    made.push_back(cage.add(place_on(row, turn), trunk_weights(place_on(skin, turn))));
  }
  return made;
}

/// A row of the same heights on the skin.
TrunkRow skin_row(const TrunkRow& row) {
  TrunkRow skin = trunk_row(row.height, 0);
  skin.drop_front = row.drop_front;
  skin.drop_back = row.drop_back;
  return skin;
}

/// A row that a deep neck pulls down; lower on the chest is further ahead.
TrunkRow scooped(const TopCut& cut, TrunkRow row, double share) {
  row.drop_front += share * cut.scoop;
  row.front += 0.5 * share * cut.scoop;
  row.drop_back += share * cut.scoop_back;
  row.back -= 0.60 * share * cut.scoop_back;
  return row;
}

std::vector<TrunkRow> upper_rows(const TopCut& cut) {
  const double e = cut.ease;
  const double s = cut.shoulder - cut.armhole_in;
  return {{1.345, 0.170 + e * 0.5 - cut.armhole_in * 0.5, 0.112 + e, -0.128 - e, 0, 0, 0.82},
          {1.412, 0.190 + e * 0.5 + s, 0.090 + e, -0.122 - e, 0, 0, 0.80},
          scooped(cut, {1.468 + e * 0.7, 0.178 + e * 0.5 + s, 0.064 + e, -0.098 - e, 0.022, 0, 0.86}, 0.55)};
}

void nudge(Cage& cage, std::size_t vertex, dvec3 step) {
  if (std::abs(cage.vertices[vertex].position.x) < 1e-9) step.x = 0;
  cage.vertices[vertex].position += step;
}

/// The hollows of the back and the corners of the shoulder.
void sculpt(Cage& cage, const std::vector<Row>& upper, std::size_t at_side) {
  for (std::size_t r = 0; r < 2; ++r) nudge(cage, upper[r].back(), {0, 0, 0.012});
  nudge(cage, upper[0][at_side], {-0.004, 0.004, 0});
  nudge(cage, upper[1][at_side - 1], {-0.004, 0, 0});
  nudge(cage, upper[2][at_side - 1], {-0.004, -0.008, 0});
  nudge(cage, upper[2][at_side + 1], {-0.004, -0.008, 0});
}

/// All but the two faces where the arm goes on.
void join_around_armhole(Cage& cage, const Row& lower, const Row& upper, std::size_t at_side, Region region) {
  for (std::size_t c = 0; c + 1 < lower.size(); ++c) {
    if (c + 1 == at_side || c == at_side) continue;
    cage.add_face({lower[c], lower[c + 1], upper[c + 1], upper[c]}, region);
  }
}

}  // namespace

double rise(double from, double to, double value) { return glm::smoothstep(from, to, value); }

TrunkRow trunk_row(double height, double ease) {
  std::size_t above = 1;
  while (above + 1 < man_rows.size() && man_rows[above].height < height) ++above;
  const TrunkRow& low = man_rows[above - 1];
  const TrunkRow& high = man_rows[above];
  const double t = std::clamp((height - low.height) / (high.height - low.height), 0.0, 1.0);
  return {height, glm::mix(low.half_width, high.half_width, t) + ease, glm::mix(low.front, high.front, t) + ease,
          glm::mix(low.back, high.back, t) - ease};
}

Weights hanging_weights(dvec3 place) {
  // The crease between trunk and thighs lies lower in the lap and at the seat than at the sides.
  const double crease =
      0.905 - 0.045 * rise(0.02, 0.10, std::abs(place.z + 0.01)) - 0.025 * rise(0.06, 0.0, std::abs(place.x));
  const double hang = rise(crease + 0.02, crease - 0.09, place.y);
  const double left = rise(-0.065, 0.065, place.x);
  const double shin = 0.92 * rise(0.53, 0.34, place.y);
  const double twist = (1 - shin) * rise(0.60, 0.80, place.y);
  const double thigh = 1 - shin - twist;
  const Weights skin = weights_at(dvec3(place.x, std::max(place.y, 0.86), place.z), {Slot::torso});
  Weights all = bind({{"thigh_twist.L", twist * left},
                      {"thigh_twist.R", twist * (1 - left)},
                      {"thigh.L", thigh * left},
                      {"thigh.R", thigh * (1 - left)},
                      {"shin.L", shin * left},
                      {"shin.R", shin * (1 - left)},
                      {"hips", 0.02 + 0.12 * rise(0.62, 0.84, place.y)}});
  for (std::size_t j = 0; j < all.size(); ++j) all[j] = hang * all[j] + (1 - hang) * skin[j];
  return all;
}

Row moved(Cage& cage, const Row& row, const std::function<dvec3(dvec3)>& step) {
  Row copy;
  for (const std::size_t vertex : row) {
    const mannequin::CageVertex from = cage.vertices[vertex];
    copy.push_back(cage.add(from.position, from.weights));
    nudge(cage, copy.back(), step(from.position));
  }
  return copy;
}

void join(Cage& cage, const Row& lower, const Row& upper, bool closed, Region region, double paint, double trim,
          bool straight) {
  const mannequin::FaceNotes before = cage.notes;
  cage.notes.trim = trim;
  cage.bridge(lower, upper, closed, region, dvec3(paint), straight);
  cage.notes = before;
}

Row add_trunk_row(Cage& cage, const TrunkRow& row, bool dense) {
  TopCut cut;
  cut.dense = dense;
  return add_row(cage, cut, row, skin_row(row));
}

void line_below(Cage& cage, const TopCut& cut, double top) {
  std::vector<Row> rows;
  for (const TrunkRow& row : cut.rows) {
    if (row.height > top) break;
    TrunkRow in = row;
    const double less = rows.empty() ? 0.001 : 0.012;
    in.half_width -= less;
    in.front -= less;
    in.back += less;
    rows.push_back(add_trunk_row(cage, in, cut.dense));
  }
  for (std::size_t r = 0; r + 1 < rows.size(); ++r) join(cage, rows[r + 1], rows[r], false, cut.region, 0.5, 0);
}

void turn_in(Cage& cage, const Row& edge, bool closed, Region region, double trim,
             const std::function<dvec3(dvec3)>& step) {
  const Row fold = moved(cage, edge, [](dvec3) { return dvec3(0); });
  join(cage, moved(cage, edge, step), fold, closed, region, fold_shade, trim);
}

TopBorders add_top(Cage& cage, const TopCut& cut) {
  const std::size_t s = side_of(cut) + (cut.gap ? 1 : 0);
  cage.notes.chart = mannequin::Chart::around_body;
  TopBorders made;
  for (const TrunkRow& row : cut.rows) made.rows.push_back(add_row(cage, cut, row, skin_row(row)));
  TopCut skin = cut;
  skin.ease = -0.005;
  skin.shoulder = 0;
  std::vector<Row> upper;
  for (std::size_t r = 0; r < 3; ++r) upper.push_back(add_row(cage, cut, upper_rows(cut)[r], upper_rows(skin)[r]));
  sculpt(cage, upper, s);

  turn_in(cage, made.rows.front(), false, cut.region, cut.hem_trim, [&](dvec3 p) {
    const dvec3 in = glm::normalize(dvec3(-p.x, 0, -p.z)) * 0.012;
    return dvec3(in.x, cut.hem_depth, in.z);
  });
  for (std::size_t r = 0; r + 1 < made.rows.size(); ++r) {
    join(cage, made.rows[r], made.rows[r + 1], false, cut.region, 1, r == 0 ? cut.hem_trim : 0);
  }
  join(cage, made.rows.back(), upper[0], false, cut.region, 1, 0);
  join_around_armhole(cage, upper[0], upper[1], s, cut.region);
  join_around_armhole(cage, upper[1], upper[2], s, cut.region);
  const double e = cut.ease;
  const TrunkRow slope_row{1.494 + e * 0.7, cut.slope_width, 0.048 + e, -0.092 - e, 0.022, -0.004, 0.95};
  TrunkRow slope_skin = slope_row;
  slope_skin.height -= e * 0.7;
  slope_skin.front -= e;
  slope_skin.back += e;
  const Row slope = add_row(cage, cut, scooped(cut, slope_row, 0.85), scooped(cut, slope_skin, 0.85));
  const TrunkRow neck_row = scooped(cut, cut.neck, 1);
  const Row neck = add_row(cage, cut, neck_row, neck_row);
  join(cage, upper[2], slope, false, cut.region, 1, 0, false);
  join(cage, slope, neck, false, cut.region, 1, 0, false);
  for (const Row& row : {upper[0], upper[1], upper[2], slope, neck}) made.rows.push_back(row);
  made.neck = neck;
  made.armhole = {upper[0][s], upper[0][s + 1], upper[1][s + 1], upper[2][s + 1],
                  upper[2][s], upper[2][s - 1], upper[1][s - 1], upper[0][s - 1]};
  return made;
}

/// Hanging arms press the inner side of a sleeve flat against the trunk.
SleeveRow pressed(SleeveRow row, Region region) {
  const double room = (region == Region::outer ? 0.047 : 0.041) - 0.065 * std::max(0.0, row.along - 0.30);
  const double outer = row.half_height + row.out;
  const double inner = row.half_height - row.out;
  const double excess = std::max(0.0, inner - room) * rise(0.14, 0.26, row.along);
  row.half_height = 0.5 * (outer + inner - excess);
  row.out = 0.5 * (outer - inner + excess);
  return row;
}

Row add_sleeve(Cage& cage, const Row& armhole, Region region, const std::vector<SleeveRow>& rows, double turned_in) {
  Row before = armhole;
  cage.notes.chart = mannequin::Chart::by_joints;
  const auto ring_of = [&](const SleeveRow& row, double along, double shrink) {
    Row ring;
    for (std::size_t k = 0; k < 8; ++k) {
      const double angle = static_cast<double>(k) * std::numbers::pi / 4;
      const dvec3 place = mannequin::left_arm().at(along, row.thumb - (row.half_width - shrink) * std::sin(angle),
                                                   row.out - (row.half_height - shrink) * std::cos(angle));
      ring.push_back(cage.add(place, weights_at(place, {Slot::upper_arms, Slot::forearms})));
    }
    return ring;
  };
  for (const SleeveRow& loose : rows) {
    const SleeveRow row = pressed(loose, region);
    const Row ring = ring_of(row, row.along, 0);
    join(cage, before, ring, true, region, row.paint, row.trim, !row.smooth);
    before = ring;
  }
  const Row inside = ring_of(pressed(rows.back(), region), rows.back().along - turned_in, 0.009);
  join(cage, moved(cage, before, [](dvec3) { return dvec3(0); }), inside, true, region, fold_shade, rows.back().trim);
  return before;
}

void hem_armhole(Cage& cage, const Row& armhole, Region region, double trim) {
  dvec3 middle(0);
  for (const std::size_t v : armhole) middle += cage.vertices[v].position / 8.0;
  const Row edge = moved(cage, armhole, [](dvec3) { return dvec3(0); });
  const Row inside =
      moved(cage, armhole, [&](dvec3 p) { return glm::normalize(p - middle) * 0.004 + dvec3(-0.012, 0, 0); });
  join(cage, edge, inside, true, region, fold_shade, trim);
}

void add_collar(Cage& cage, Region region, double from, double trim,
                const std::function<std::vector<CollarPoint>(double)>& profile) {
  constexpr std::size_t steps = 7;
  std::vector<Row> rows;
  for (std::size_t c = 0; c < steps; ++c) {
    const double degrees = from + (180 - from) * static_cast<double>(c) / (steps - 1);
    const std::vector<CollarPoint> points = profile(degrees);
    rows.resize(points.size());
    const double angle = degrees * std::numbers::pi / 180;
    const double sine = c + 1 == steps ? 0 : std::sin(angle);
    for (std::size_t r = 0; r < points.size(); ++r) {
      const auto [out, up] = points[r];
      const double drop = 0.030 * std::max(0.0, std::cos(angle));
      const dvec3 place((0.060 + out) * sine, 1.512 - drop + up, -0.019 + (0.056 + out) * std::cos(angle));
      const double neck = std::clamp(0.42 - out * 6 + up * 4, 0.05, 0.6);
      Weights weights = bind({{"upper_chest", 1 - neck}, {"neck", neck}});
      rows[r].push_back(cage.add(place, weights));
    }
  }
  for (std::size_t r = 0; r + 1 < rows.size(); ++r) join(cage, rows[r + 1], rows[r], false, region, 1, trim, true);
}

}  // namespace throng::wardrobe
