#include <array>

#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/footwear.h"
#include "assets/wardrobe/part.h"
#include "assets/wardrobe/sewing.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

Skin shoe(const ShoeCut& cut) {
  Cage half;
  add_shoe(half, cut);
  return mirrored_surface(half);
}

}  // namespace

Skin make_trainers() {
  Skin trainers =
      shoe({.sole = 0.024,
            .sole_grow = 1.07,
            .upper_grow = 1.03,
            .ball_height = 0.068,
            .toe_height = 0.060,
            .toe_trim = 0,
            .shaft = {{0.088, 0.042, 0.050, -0.021, 0.004}, {0.096, 0.041, 0.048, -0.021, 0.004, 1, 0.95}}});
  for (const double z : {0.052, 0.067, 0.082}) {
    sew_on(trainers, {.rows = {{{0.088, z - 0.004}, {0.109, z - 0.002}, {0.130, z - 0.004}},
                               {{0.088, z + 0.003}, {0.109, z + 0.005}, {0.130, z + 0.003}}},
                      .from = LaidFrom::above,
                      .region = Region::shoes,
                      .lift = 0.004,
                      .trim = 1,
                      .both_sides = true});
  }
  return trainers;
}

Skin make_leather_shoes() {
  return shoe({.sole = 0.014,
               .sole_grow = 1.035,
               .upper_grow = 1.0,
               .pointed = 0.010,
               .sole_trim = 0,
               .sole_paint = 0.45,
               .shaft = {{0.084, 0.039, 0.048, -0.020, 0.004}, {0.090, 0.038, 0.047, -0.020, 0.004, 0, 0.8}}});
}

Skin make_boots() {
  return shoe({.sole = 0.026,
               .sole_grow = 1.07,
               .upper_grow = 1.03,
               .ball_height = 0.080,
               .toe_height = 0.064,
               .sole_trim = 1,
               .sole_paint = 0.8,
               .toe_trim = 0,
               .shaft = {{0.092, 0.043, 0.055, -0.016, 0.012},
                         {0.132, 0.041, 0.049, -0.018},
                         {0.166, 0.043, 0.050, -0.017},
                         {0.182, 0.044, 0.051, -0.017, 0, 1, 0.9}}});
}

Skin make_heeled_boots() {
  return shoe(
      {.sole = 0.012,
       .sole_grow = 1.0,
       .upper_grow = 0.99,
       .pointed = 0.011,
       .heel = 0.042,
       .heel_block = 0.028,
       .ball_height = 0.066,
       .sole_trim = 0,
       .sole_paint = 0.4,
       .shaft = {{0.098, 0.040, 0.052, -0.016, 0.006}, {0.130, 0.038, 0.046, -0.018}, {0.152, 0.040, 0.047, -0.018}}});
}

Skin make_wellingtons() {
  return shoe({.sole = 0.022,
               .sole_grow = 1.08,
               .upper_grow = 1.06,
               .ball_height = 0.084,
               .toe_height = 0.066,
               .sole_trim = 1,
               .shaft = {{0.084, 0.062, 0.076, -0.012, 0.030},
                         {0.160, 0.060, 0.069, -0.016},
                         {0.250, 0.068, 0.076, -0.015},
                         {0.325, 0.072, 0.081, -0.014},
                         {0.342, 0.074, 0.083, -0.014, 0, 1}}});
}

Skin make_ballet_flats() {
  const ShoeCut cut{.pointed = 0.004};
  Cage half;
  half.notes.chart = mannequin::Chart::from_side;
  const auto row = [](const Outline& o) { return Row(o.begin(), o.end()); };
  const Outline ground = add_outline(half, cut, 0, 1.02, 0.003);
  const Outline welt = add_outline(half, cut, 0.010, 1.05, 0.005);
  const Outline side = add_outline(half, cut, 0.026, 1.055, 0.005);
  Outline edge = add_outline(half, cut, 0.042, 1.02, 0);
  // The vamp ends behind the toes, the heel is a little higher.
  constexpr std::array<double, 3> across{0.079, 0.109, 0.139};
  for (std::size_t i = 0; i < 3; ++i) {
    half.vertices[edge[i]].position = {across[i], i == 1 ? 0.073 : 0.065, i == 1 ? 0.116 : 0.122};
    half.vertices[side[i]].position.y = 0.036;
  }
  for (const std::size_t i : {6U, 7U, 8U}) half.vertices[edge[i]].position.y = 0.056;
  join(half, row(ground), row(welt), true, Region::shoes, 0.45, 0);
  join(half, row(welt), row(side), true, Region::shoes, 1, 0);
  join(half, row(side), row(edge), true, Region::shoes, 1, 0);
  const Row inside =
      moved(half, row(edge), [](dvec3 p) { return dvec3((0.105 - p.x) * 0.12, -0.006, (0.045 - p.z) * 0.08); });
  join(half, moved(half, row(edge), [](dvec3) { return dvec3(0); }), inside, true, Region::shoes, 0.7, 1);
  return mirrored_surface(half);
}

Skin make_sandals() {
  const ShoeCut cut;
  Cage half;
  half.notes.chart = mannequin::Chart::from_side;
  const auto row = [](const Outline& o) { return Row(o.begin(), o.end()); };
  const Outline ground = add_outline(half, cut, 0, 1.05, 0.003);
  const Outline top = add_outline(half, cut, 0.016, 1.075, 0.004);
  const Outline inner = add_outline(half, cut, 0.015, 0.98, 0.004);
  join(half, row(ground), row(top), true, Region::shoes, 0.9, 1);
  join(half, moved(half, row(top), [](dvec3) { return dvec3(0); }), row(inner), true, Region::shoes, 0.75, 1);
  // Straps over the ball, over the instep and around the heel.
  const auto strap = [&](const std::array<dvec3, 7>& behind, const std::array<dvec3, 7>& ahead) {
    std::array<Row, 2> rows;
    for (std::size_t i = 0; i < 7; ++i) {
      rows[0].push_back(half.add(behind[i], weights_at(behind[i], {Slot::feet, Slot::shins})));
      rows[1].push_back(half.add(ahead[i], weights_at(ahead[i], {Slot::feet, Slot::shins})));
    }
    join(half, rows[1], rows[0], false, Region::shoes, 1, 0);
  };
  const auto arc = [](double z, double wide, double high) {
    std::array<dvec3, 7> places{};
    constexpr std::array<double, 7> across{-0.050, -0.049, -0.036, 0, 0.036, 0.049, 0.051};
    constexpr std::array<double, 7> up{0.010, 0.034, 0.066, 0.078, 0.066, 0.034, 0.010};
    for (std::size_t i = 0; i < 7; ++i) places[i] = {0.108 + across[i] * wide, up[i] * high, z};
    return places;
  };
  strap(arc(0.074, 1.02, 1.06), arc(0.112, 1.00, 0.78));
  const std::array<dvec3, 7> high{{{0.062, 0.074, 0.020},
                                   {0.062, 0.072, -0.020},
                                   {0.074, 0.070, -0.062},
                                   {0.103, 0.070, -0.080},
                                   {0.132, 0.070, -0.062},
                                   {0.143, 0.072, -0.020},
                                   {0.145, 0.074, 0.020}}};
  std::array<dvec3, 7> low = high;
  for (dvec3& place : low) place.y -= 0.022;
  strap(low, high);
  strap(arc(0.012, 0.86, 1.36), arc(0.036, 0.90, 1.24));
  return mirrored_surface(half);
}

std::vector<Part> shoes() {
  constexpr Slot shoes = Slot::shoes;
  const std::vector<Slot> feet{Slot::feet};
  return {
      {"trainers", shoes, Fits::all, feet, {"sport", "casual"}, {}, make_trainers},
      {"leather_shoes", shoes, Fits::adults, feet, {"formal"}, {}, make_leather_shoes},
      {"boots", shoes, Fits::all, feet, {"cold", "work"}, {}, make_boots},
      {"heeled_boots", shoes, Fits::woman, feet, {"formal", "cold"}, {}, make_heeled_boots},
      {"ballet_flats", shoes, Fits::women_and_children, {}, {"summer", "formal"}, {}, make_ballet_flats},
      {"sandals", shoes, Fits::all, {}, {"summer"}, {}, make_sandals},
      {"wellingtons", shoes, Fits::all, feet, {"rain", "over_trousers"}, {}, make_wellingtons},
  };
}

}  // namespace throng::wardrobe
