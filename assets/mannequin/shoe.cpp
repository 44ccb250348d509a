#include <array>
#include <vector>

#include "assets/mannequin/body_parts.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// Inner, middle and outer vertex of a cross-section.
using ShoeRow = std::array<std::size_t, 3>;
using Outline = std::array<std::size_t, 12>;
constexpr dvec3 sole_paint{0.55, 0.55, 0.55};

/// The sole below the ball goes with the toes, so that it stays on the ground while the foot rolls off.
Weights foot_weights(double z, double share_at_ball) {
  const double toe = z < 0.085 ? 0.0 : (z < 0.125 ? share_at_ball : 1.0);
  return bind({{"foot.L", 1 - toe}, {"toe.L", toe}});
}

/// Outline at one height: toe cap from the inner to the outer side, back along the outer side, the heel, the inner
/// side.
Outline add_outline(Cage& cage, double height, double grow, double toe_spring) {
  constexpr std::array<std::array<double, 2>, 12> plan{{{0.078, 0.160},
                                                        {0.109, 0.184},
                                                        {0.141, 0.150},
                                                        {0.155, 0.090},
                                                        {0.143, 0.030},
                                                        {0.137, -0.022},
                                                        {0.130, -0.066},
                                                        {0.103, -0.085},
                                                        {0.076, -0.066},
                                                        {0.070, -0.022},
                                                        {0.070, 0.030},
                                                        {0.064, 0.092}}};
  constexpr double centre_x = 0.105;
  constexpr double centre_z = 0.045;
  Outline outline{};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto [x, z] = plan[i];
    const double lift = z > 0.14 ? toe_spring : 0.0;
    outline[i] = cage.add({centre_x + (x - centre_x) * grow, height + lift, centre_z + (z - centre_z) * grow},
                          foot_weights(z, 0.8));
  }
  return outline;
}

ShoeRow add_top_row(Cage& cage, double z, double x, double half_width, double height, double ridge) {
  const Weights weights = foot_weights(z, 0.5);
  return {cage.add({x - half_width, height, z}, weights), cage.add({x, height + ridge, z}, weights),
          cage.add({x + half_width, height, z}, weights)};
}

void bridge_rows(Cage& cage, const ShoeRow& behind, const ShoeRow& ahead, bool facing_down) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (facing_down) {
      cage.add_face({behind[i], behind[i + 1], ahead[i + 1], ahead[i]}, Region::shoes, sole_paint);
    } else {
      cage.add_face({ahead[i], ahead[i + 1], behind[i + 1], behind[i]}, Region::shoes);
    }
  }
}

void bridge_sole(Cage& cage, const Outline& o) {
  std::array<std::size_t, 3> middle{};
  constexpr std::array<double, 3> along{-0.022, 0.030, 0.092};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = 0.5 * (cage.vertices[o[9 + i]].position.x + cage.vertices[o[5 - i]].position.x);
    middle[i] = cage.add({x, 0.0, along[i]}, foot_weights(along[i], 0.8));
  }
  const std::array<ShoeRow, 5> rows{{{o[8], o[7], o[6]},
                                     {o[9], middle[0], o[5]},
                                     {o[10], middle[1], o[4]},
                                     {o[11], middle[2], o[3]},
                                     {o[0], o[1], o[2]}}};
  for (std::size_t r = 0; r + 1 < rows.size(); ++r) bridge_rows(cage, rows[r], rows[r + 1], true);
}

}  // namespace

void add_shoe(Cage& cage, const LimbRing& cuff) {
  const ShoeRow ankle{cuff[0], cuff[1], cuff[2]};
  const ShoeRow ball = add_top_row(cage, 0.090, 0.109, 0.033, 0.063, 0.006);
  const ShoeRow toe = add_top_row(cage, 0.140, 0.109, 0.028, 0.050, 0.004);
  bridge_rows(cage, ankle, ball, false);
  bridge_rows(cage, ball, toe, false);

  const Outline top{toe[0],  toe[1],  toe[2],  ball[2], cuff[2], cuff[3],
                    cuff[4], cuff[5], cuff[6], cuff[7], cuff[0], ball[0]};
  const Outline welt = add_outline(cage, 0.022, 1.0, 0.006);
  const Outline ground = add_outline(cage, 0.0, 0.96, 0.004);
  for (std::size_t i = 0; i < top.size(); ++i) {
    const std::size_t next = (i + 1) % top.size();
    cage.add_face({welt[i], welt[next], top[next], top[i]}, Region::shoes);
  }
  cage.bridge(ground, welt, true, Region::shoes, sole_paint, true);
  bridge_sole(cage, ground);
}

}  // namespace throng::mannequin
