#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"
#include "assets/places/shapes.h"

namespace throng::places {
namespace {

/// A jet that falls in a bow from (radius0, y0) to (radius1, y1).
void jet(MeshBuilder& builder, double turn, dvec2 from, dvec2 to, double bow, double width, int pieces) {
  Paint paint{.color = rgb(0xDCE8EA), .kind = Kind::water, .baked = false};
  const dvec3 way(sine(turn), 0, cosine(turn));
  const dvec3 across(cosine(turn), 0, -sine(turn));
  const auto at = [&](double t) {
    const double r = from.x + (to.x - from.x) * t;
    const double y = from.y + (to.y - from.y) * t + 4 * bow * t * (1 - t);
    return way * r + dvec3(0, y, 0);
  };
  for (int i = 0; i < pieces; ++i) {
    const double t0 = static_cast<double>(i) / pieces, t1 = static_cast<double>(i + 1) / pieces;
    const double w0 = width * (0.6 + 0.7 * t0), w1 = width * (0.6 + 0.7 * t1);
    builder.quad(at(t0) - across * w0, at(t0) + across * w0, at(t1) + across * w1, at(t1) - across * w1, paint);
  }
}

/// Three basins above each other, 6 m across, with water that falls from one to the next. The rim is a seat, 0.44 m
/// above a plinth for the feet.
void fountain(MeshBuilder& builder, int lod) {
  const Paint stone = paints::pale_stone;
  const int sides = lod == 0 ? 20 : lod == 1 ? 12 : 8;
  const bool fine = lod < 2;
  lathe(builder, {{3.46, 0}, {3.46, 0.15}, {3.43, 0.18}, {2.8, 0.18}}, sides, shaded(stone, 0.9),
        fine ? Turned::edged : Turned::faceted);
  if (fine) {
    lathe(builder,
          {{3.0, 0.18},
           {2.82, 0.16},
           {2.78, 0.46},
           {2.9, 0.5},
           {2.96, 0.55},
           {2.96, 0.62},
           {2.6, 0.62},
           {2.55, 0.58},
           {2.55, 0.3}},
          sides, stone);
    lathe(builder, {{1.0, 0.3}, {0.8, 0.62}, {0.5, 0.72}, {0.34, 0.95}, {0.3, 1.25}, {0.42, 1.4}}, sides / 2,
          shaded(stone, 0.95));
    lathe(builder, {{0.42, 1.4}, {1.0, 1.58}, {1.32, 1.72}, {1.4, 1.78}, {1.36, 1.86}, {1.26, 1.84}, {1.2, 1.74}},
          sides, stone);
    lathe(builder, {{0.26, 1.7}, {0.2, 1.9}, {0.16, 2.25}, {0.22, 2.4}}, sides / 2, stone);
    lathe(builder, {{0.22, 2.4}, {0.5, 2.5}, {0.68, 2.62}, {0.66, 2.7}, {0.58, 2.68}, {0.54, 2.6}}, sides / 2, stone);
    lathe(builder, {{0.1, 2.6}, {0.16, 2.78}, {0.08, 2.95}, {0, 3.1}}, 8, stone);
  } else {
    lathe(builder, {{3.0, 0}, {2.9, 0.62}, {2.6, 0.62}, {2.55, 0.4}}, sides, stone, Turned::faceted);
    lathe(builder, {{0.6, 0.4}, {0.3, 1.3}, {1.4, 1.78}}, 6, stone);
    lathe(builder, {{0.2, 1.7}, {0.2, 2.4}, {0.66, 2.65}}, 5, stone);
  }
  disc(builder, 2.56, 0.5, sides, paints::water);
  disc(builder, fine ? 1.24 : 1.4, 1.79, sides, paints::water);
  disc(builder, fine ? 0.56 : 0.66, 2.65, fine ? sides / 2 : 5, paints::water);
  const int jets = lod == 0 ? 24 : lod == 1 ? 12 : 6;
  const int pieces = lod == 0 ? 5 : 3;
  for (int i = 0; i < jets; ++i) {
    const double turn = (i + 0.5) / jets;
    const double reach = 0.18 * chance(44, static_cast<std::uint32_t>(i));
    jet(builder, turn, {1.38, 1.84}, {1.62 + reach, 0.5}, 0.12, lod == 0 ? 0.028 : 0.05, pieces);
    if (i % 2 == 0) jet(builder, turn, {0.64, 2.68}, {0.82 + 0.5 * reach, 1.79}, 0.08, lod == 0 ? 0.022 : 0.04, pieces);
  }
  for (int i = 0; i < (fine ? 6 : 3); ++i)
    jet(builder, i / (fine ? 6.0 : 3.0), {0.02, 3.05}, {0.35, 2.65}, 0.45, 0.018, 4);
}

}  // namespace

std::vector<Prop> fountain_props() { return {{"fountain", {0, 0.03, 0.12}, fountain, 1.0}}; }

}  // namespace throng::places
