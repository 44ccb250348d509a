#include "assets/wardrobe/trousers.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/sewing.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

constexpr double half_turn = std::numbers::pi;

/// Angles around the trunk, in front first; a stripe has two columns of its own beside the seam.
std::vector<double> trunk_angles(double stripe) {
  if (stripe > 0) return {0, 30, 60, 90 - stripe / 0.0029, 90 + stripe / 0.0029, 120, 150, 180};
  return {0, 30, 60, 90, 120, 150, 180};
}

/// Angles around the leg for the same columns, and the inner side last.
std::vector<double> leg_angles(double stripe) {
  if (stripe > 0) return {-45, 0, 45, 90 - stripe / 0.00105, 90 + stripe / 0.00105, 135, 180, 225, 270};
  return {-45, 0, 45, 90, 135, 180, 225, 270};
}

struct HipRow {
  double height, half_width, front, back, drop_front, drop_back;
};

Row add_hip_row(Cage& cage, const HipRow& hip, const std::vector<double>& angles) {
  Row row;
  for (const double degrees : angles) {
    const double sine = degrees == 0 || degrees == 180 ? 0 : std::sin(degrees * half_turn / 180);
    const double cosine = degrees == 90 ? 0 : std::cos(degrees * half_turn / 180);
    const double drop = cosine > 0 ? hip.drop_front * cosine : -hip.drop_back * cosine;
    const double squareness = 0.9;
    const dvec3 place(hip.half_width * std::pow(sine, squareness), hip.height - drop,
                      0.5 * (hip.front + hip.back) +
                          0.5 * (hip.front - hip.back) * std::copysign(std::pow(std::abs(cosine), squareness), cosine));
    row.push_back(cage.add(place, weights_at(place, {Slot::torso})));
  }
  return row;
}

/// Bends where the skin does: the middle of the crease stays with the hips.
void bind_crease(Cage& cage, const Row& crease) {
  for (const std::size_t v : crease) {
    const bool middle = std::abs(cage.vertices[v].position.x) < 1e-9;
    cage.vertices[v].weights = middle ? mannequin::bind({{"hips", 1}})
                                      : mannequin::bind({{"hips", 0.5}, {"thigh.L", 0.3}, {"thigh_twist.L", 0.2}});
  }
}

Row add_leg_row(Cage& cage, const LegRow& leg, const std::vector<double>& angles, double crease, double shrink) {
  Row row;
  for (const double degrees : angles) {
    const double angle = degrees * half_turn / 180;
    const double height = leg.height + leg.lift_front * 0.5 * (1 + std::cos(angle));
    dvec3 place(leg.x + (leg.half_width - shrink) * std::sin(angle), height,
                leg.z + (leg.half_depth - shrink) * std::cos(angle));
    if (degrees == 0) place.z += crease;
    row.push_back(cage.add(place, weights_at(place, {Slot::thighs, Slot::shins})));
  }
  return row;
}

/// A band of the leg; the stripe's column has the second colour.
void join_leg(Cage& cage, const Row& lower, const Row& upper, Region region, const LegRow& row, bool striped) {
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t next = (i + 1) % lower.size();
    cage.notes.trim = striped && i == 3 ? 1 : row.trim;
    const std::size_t face = cage.add_face({lower[i], lower[next], upper[next], upper[i]}, region, dvec3(row.paint));
    cage.faces[face].straight = true;
  }
  cage.notes.trim = 0;
}

}  // namespace

std::vector<LegRow> leg_rows(double thigh, double knee, double calf, double hem, double hem_height) {
  return {{0.790, 0.094, -0.006, 0.083 + thigh * 0.6, 0.090 + thigh},
          {0.660, 0.097, 0.000, 0.070 + thigh * 0.8, 0.076 + thigh},
          {0.530, 0.098, 0.005, 0.057 + knee, 0.062 + knee},
          {0.460, 0.098, 0.000, 0.053 + knee, 0.057 + knee},
          {0.340, 0.100, -0.014, 0.053 + calf, 0.058 + calf},
          {hem_height + 0.045, 0.102, -0.016, 0.038 + hem, 0.047 + hem, 0, 1, 0.020},
          {hem_height, 0.102, -0.012, 0.039 + hem, 0.052 + hem, 0, 1, 0.030}};
}

void add_trousers(Cage& cage, const TrouserCut& cut) {
  const std::vector<double> around = trunk_angles(cut.stripe);
  const std::vector<double> leg_around = leg_angles(cut.stripe);
  const double e = cut.ease;
  const bool striped = cut.stripe > 0;
  const Row inside = add_hip_row(cage, {cut.waist - 0.016, 0.146 + e, 0.088 + e, -0.100 - e, 0.006, 0}, around);
  const Row top = add_hip_row(cage, {cut.waist, 0.158 + e, 0.099 + e, -0.113 - e, 0.006, 0}, around);
  const Row band = add_hip_row(cage, {cut.waist - 0.038, 0.165 + e, 0.101 + e, -0.127 - e, 0.006, 0}, around);
  Row crease = add_hip_row(cage, {0.905, 0.167 + e, 0.098 + e, -0.126 - e, 0.046, 0.055}, around);
  bind_crease(cage, crease);
  const auto move = [&](std::size_t v, dvec3 step) { cage.vertices[v].position += step; };
  move(crease[crease.size() - 2], {0.006, -0.006, -0.004});
  move(crease.back(), {0, 0, 0.018});
  join(cage, top, inside, false, cut.region, 0.75, cut.band_trim);
  join(cage, band, top, false, cut.region, 1, cut.band_trim);
  join(cage, crease, band, false, cut.region, 1, 0, false);
  if (striped) {
    for (std::size_t f = cage.faces.size() - (around.size() - 1); f < cage.faces.size(); ++f) {
      if (f == cage.faces.size() - (around.size() - 1) + 3) cage.faces[f].notes.trim = 1;
    }
  }
  crease.push_back(cage.add({0, 0.828, 0.006}, mannequin::bind({{"hips", 0.6}, {"thigh.L", 0.4}})));
  Row upper = crease;
  for (const LegRow& leg : cut.legs) {
    const Row row = add_leg_row(cage, leg, leg_around, cut.crease * rise(0.85, 0.66, leg.height), 0);
    join_leg(cage, row, upper, cut.region, leg, striped);
    upper = row;
  }
  if (!cut.turned_in) return;
  LegRow hem = cut.legs.back();
  hem.height += 0.014;
  hem.paint = 0.7;
  const Row edge = moved(cage, upper, [](dvec3) { return dvec3(0); });
  join_leg(cage, add_leg_row(cage, hem, leg_around, 0, 0.009), edge, cut.region, hem, false);
}

Skin make_jeans() {
  Cage half;
  add_trousers(half, {.band_trim = 0, .legs = leg_rows(0.006, 0.008, 0.008, 0.011, 0.072)});
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0022);
  sew_on(cloth,
         {.rows = {{{0.052, 0.820}, {0.085, 0.806}, {0.118, 0.820}}, {{0.046, 0.885}, {0.085, 0.882}, {0.124, 0.888}}},
          .from = LaidFrom::back,
          .region = Region::trousers,
          .lift = 0.003,
          .both_sides = true});
  return cloth;
}

Skin make_chinos() {
  Cage half;
  std::vector<LegRow> legs = leg_rows(0.009, 0.009, 0.007, 0.011, 0.085);
  LegRow& cuff = legs.back();
  legs.insert(legs.end() - 1,
              {cuff.height + 0.030, cuff.x, cuff.z, cuff.half_width, cuff.half_depth, 0, 1, cuff.lift_front});
  for (std::size_t r = legs.size() - 1; r < legs.size(); ++r) {
    legs[r].half_width += 0.004;
    legs[r].half_depth += 0.004;
    legs[r].trim = 1;
    legs[r].paint = 0.95;
  }
  add_trousers(half, {.ease = 0.006, .legs = legs});
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0020);
  return cloth;
}

Skin make_suit_trousers() {
  Cage half;
  add_trousers(half, {.ease = 0.006, .legs = leg_rows(0.012, 0.016, 0.014, 0.026, 0.050), .crease = 0.010});
  return mirrored_surface(half);
}

Skin make_shorts() {
  Cage half;
  std::vector<LegRow> legs{{0.790, 0.096, -0.006, 0.089, 0.098},
                           {0.680, 0.098, 0.000, 0.083, 0.089},
                           {0.600, 0.099, 0.002, 0.080, 0.086},
                           {0.570, 0.099, 0.002, 0.080, 0.086, 1}};
  add_trousers(half, {.ease = 0.006, .legs = legs});
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0025);
  return cloth;
}

Skin make_leggings() {
  Cage half;
  std::vector<LegRow> legs = leg_rows(0.003, 0.0035, 0.0035, 0.003, 0.110);
  legs.insert(legs.begin() + 5, {0.220, 0.101, -0.016, 0.0435, 0.050});
  add_trousers(half, {.ease = 0.003, .band_trim = 1, .legs = legs});
  return mirrored_surface(half);
}

Skin make_cargo_trousers() {
  Cage half;
  std::vector<LegRow> legs = leg_rows(0.018, 0.018, 0.011, 0.012, 0.076);
  add_trousers(half, {.ease = 0.006, .legs = legs});
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0034);
  for (const bool flap : {false, true}) {
    sew_on(cloth, {.rows = flap ? rectangle({0.028, 0.690}, {-0.060, 0.725}, 1, 2)
                                : rectangle({0.026, 0.560}, {-0.056, 0.712}, 2, 2),
                   .from = LaidFrom::left,
                   .region = Region::trousers,
                   .lift = flap ? 0.011 : 0.008,
                   .paint = flap ? 0.94 : 1,
                   .both_sides = true});
  }
  return cloth;
}

Skin make_track_trousers() {
  Cage half;
  std::vector<LegRow> legs = leg_rows(0.012, 0.014, 0.012, 0.012, 0.085);
  add_trousers(half, {.ease = 0.006, .band_trim = 1, .legs = legs, .stripe = 0.016});
  Skin cloth = mirrored_surface(half);
  crumple(cloth, 0.0022);
  return cloth;
}

}  // namespace throng::wardrobe
