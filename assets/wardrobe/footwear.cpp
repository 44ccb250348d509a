#include "assets/wardrobe/footwear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace throng::wardrobe {
namespace {

using glm::dvec2;
using glm::dvec3;
using mannequin::bind;
using mannequin::Weights;

constexpr double centre_x = 0.105;
constexpr double centre_z = 0.045;
using Three = std::array<std::size_t, 3>;

/// The sole below the ball goes with the toes, as the foot's own.
Weights foot_weights(double z, double share_at_ball) {
  const double toe = z < 0.085 ? 0.0 : (z < 0.125 ? share_at_ball : 1.0);
  return bind({{"foot.L", 1 - toe}, {"toe.L", toe}});
}

/// Returns how far a place along the foot has risen to a heel.
double arch(const ShoeCut& cut, double z) { return cut.heel * rise(0.085, -0.040, z); }

Three add_top_row(Cage& cage, double z, double half_width, double height, double ridge) {
  const Weights weights = foot_weights(z, 0.5);
  return {cage.add({0.109 - half_width, height, z}, weights), cage.add({0.109, height + ridge, z}, weights),
          cage.add({0.109 + half_width, height, z}, weights)};
}

void join_three(Cage& cage, const Three& behind, const Three& ahead, double trim, bool down, double paint) {
  cage.notes.trim = trim;
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<std::size_t> corners{ahead[i], ahead[i + 1], behind[i + 1], behind[i]};
    if (down) corners = {behind[i], behind[i + 1], ahead[i + 1], ahead[i]};
    cage.add_face(corners, Region::shoes, dvec3(paint));
  }
  cage.notes.trim = 0;
}

Row add_shaft_row(Cage& cage, const ShaftRow& shaft, double shrink, double drop) {
  Row row;
  for (int k = 0; k < 8; ++k) {
    const double angle = (k - 1) * std::numbers::pi / 4;
    const double x = shaft.half_width - shrink;
    const double z = shaft.half_depth - shrink;
    const dvec3 place(0.102 + x * std::sin(angle), shaft.height + shaft.rise_front * 0.5 * (1 + std::cos(angle)) - drop,
                      shaft.z + z * std::cos(angle));
    row.push_back(cage.add(place, weights_at(place, {Slot::shins, Slot::feet})));
  }
  return row;
}

/// A block below the heel, open above.
void add_heel(Cage& cage, const ShoeCut& cut) {
  Row top, bottom;
  for (int k = 0; k < 8; ++k) {
    const double angle = k * std::numbers::pi / 4;
    const dvec2 out(std::sin(angle), std::cos(angle));
    const double size = cut.heel_block;
    top.push_back(cage.add({0.103 + size * 1.1 * out.x, cut.heel + cut.sole * 0.6, -0.048 + size * 1.15 * out.y},
                           bind({{"foot.L", 1}})));
    bottom.push_back(cage.add({0.103 + size * 0.9 * out.x, 0, -0.052 + size * 0.9 * out.y}, bind({{"foot.L", 1}})));
  }
  join(cage, bottom, top, true, Region::shoes, cut.sole_paint, cut.sole_trim);
  const Row edge = moved(cage, bottom, [](dvec3) { return dvec3(0); });
  Row turned(edge.rbegin(), edge.rend());
  cage.notes.trim = cut.sole_trim;
  cage.add_face(turned, Region::shoes, dvec3(0.5));
  cage.notes.trim = 0;
}

}  // namespace

Outline add_outline(Cage& cage, const ShoeCut& cut, double height, double grow, double toe_spring) {
  constexpr std::array<std::array<double, 2>, 12> plan{{{0.079, 0.166},
                                                        {0.110, 0.183},
                                                        {0.140, 0.160},
                                                        {0.155, 0.090},
                                                        {0.143, 0.030},
                                                        {0.137, -0.022},
                                                        {0.130, -0.066},
                                                        {0.103, -0.085},
                                                        {0.076, -0.066},
                                                        {0.070, -0.022},
                                                        {0.070, 0.030},
                                                        {0.064, 0.092}}};
  Outline outline{};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    auto [x, z] = plan[i];
    if (i == 1) z += cut.pointed;
    if (i == 0 || i == 2) x += (centre_x + 0.003 - x) * cut.pointed * 18;
    const double lift = z > 0.14 ? toe_spring : 0.0;
    outline[i] =
        cage.add({centre_x + (x - centre_x) * grow, height + lift + arch(cut, z), centre_z + (z - centre_z) * grow},
                 foot_weights(z, 0.8));
  }
  return outline;
}

void close_sole(Cage& cage, const Outline& o, double trim, double paint) {
  Three middle{};
  constexpr std::array<double, 3> along{-0.022, 0.030, 0.092};
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 across = 0.5 * (cage.vertices[o[9 + i]].position + cage.vertices[o[5 - i]].position);
    middle[i] = cage.add({across.x, across.y, along[i]}, foot_weights(along[i], 0.8));
  }
  const std::array<Three, 5> rows{{{o[8], o[7], o[6]},
                                   {o[9], middle[0], o[5]},
                                   {o[10], middle[1], o[4]},
                                   {o[11], middle[2], o[3]},
                                   {o[0], o[1], o[2]}}};
  for (std::size_t r = 0; r + 1 < rows.size(); ++r) join_three(cage, rows[r], rows[r + 1], trim, true, paint);
}

void add_shoe(Cage& cage, const ShoeCut& cut) {
  cage.notes.chart = mannequin::Chart::from_side;
  const Outline ground = add_outline(cage, cut, 0, cut.sole_grow - 0.03, 0.004);
  const Outline edge = add_outline(cage, cut, cut.sole, cut.sole_grow, 0.006);
  const Outline welt = add_outline(cage, cut, cut.sole + 0.001, cut.upper_grow - 0.01, 0.006);
  const Outline side = add_outline(cage, cut, cut.sole + 0.014, cut.upper_grow, 0.006);
  const Row crisp_ground = moved(cage, Row(ground.begin(), ground.end()), [](dvec3) { return dvec3(0); });
  Outline below{};
  std::copy(crisp_ground.begin(), crisp_ground.end(), below.begin());
  const auto row = [](const Outline& o) { return Row(o.begin(), o.end()); };
  join(cage, row(ground), row(edge), true, Region::shoes, cut.sole_paint, cut.sole_trim);
  const Row top_edge = moved(cage, row(edge), [](dvec3) { return dvec3(0); });
  join(cage, top_edge, row(welt), true, Region::shoes, cut.sole_paint * 0.8, cut.sole_trim);
  const Row foot = moved(cage, row(welt), [](dvec3) { return dvec3(0); });
  join(cage, foot, row(side), true, Region::shoes, 0.9, 0);
  close_sole(cage, below, cut.sole_trim, cut.sole_paint * 0.6);

  const Row cuff = add_shaft_row(cage, cut.shaft.front(), 0, 0);
  const Three ankle{cuff[0], cuff[1], cuff[2]};
  const Three ball = add_top_row(cage, 0.090, 0.035, cut.ball_height, 0.007);
  const Three toe = add_top_row(cage, 0.140 + cut.pointed * 0.5, 0.029, cut.toe_height, 0.004);
  join_three(cage, ankle, ball, 0, false, 1);
  join_three(cage, ball, toe, cut.toe_trim, false, 1);
  const Row top{toe[0],  toe[1],  toe[2],  ball[2], cuff[2], cuff[3],
                cuff[4], cuff[5], cuff[6], cuff[7], cuff[0], ball[0]};
  for (std::size_t i = 0; i < top.size(); ++i) {
    const std::size_t next = (i + 1) % top.size();
    cage.notes.trim = i < 2 ? cut.toe_trim : 0;
    cage.add_face({side[i], side[next], top[next], top[i]}, Region::shoes);
  }
  cage.notes.trim = 0;
  Row lower = cuff;
  for (std::size_t r = 1; r < cut.shaft.size(); ++r) {
    const Row upper = add_shaft_row(cage, cut.shaft[r], 0, 0);
    join(cage, lower, upper, true, Region::shoes, cut.shaft[r].paint, cut.shaft[r].trim);
    lower = upper;
  }
  const Row inside = add_shaft_row(cage, cut.shaft.back(), 0.008, 0.014);
  join(cage, moved(cage, lower, [](dvec3) { return dvec3(0); }), inside, true, Region::shoes, 0.6,
       cut.shaft.back().trim);
  if (cut.heel > 0) add_heel(cage, cut);
}

}  // namespace throng::wardrobe
