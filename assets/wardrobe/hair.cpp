#include "assets/wardrobe/hair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/curve.h"
#include "assets/wardrobe/head_surface.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Region;
using mannequin::Skin;

std::size_t add_hair_point(Skin& skin, dvec3 place) {
  skin.points.push_back({.position = place, .weights = hair_weights(place)});
  return skin.points.size() - 1;
}

}  // namespace

mannequin::Weights hair_weights(dvec3 place) {
  const double on_head = glm::smoothstep(1.46, 1.60, place.y);
  const double on_chest = (1 - glm::smoothstep(1.42, 1.55, place.y)) * (1 - on_head);
  return mannequin::bind({{"head", on_head}, {"neck", 1 - on_head - on_chest}, {"upper_chest", on_chest}});
}

dvec3 strand_paint(double angle, double along) {
  const double wave =
      std::sin(angle * 0.42 + 1.7 * std::sin(angle * 0.11)) + 0.7 * std::sin(angle * 0.93 + 2.0 * along);
  return dvec3(0.88 + 0.10 * wave);
}

Skin hair_surface(const HairPlan& plan) {
  Skin skin;
  const bool around = plan.to - plan.from >= 360;
  const std::size_t count = around ? plan.columns : plan.columns + 1;
  std::vector<std::vector<std::size_t>> columns;
  std::vector<std::vector<dvec3>> paints;
  std::size_t crown = 0;
  for (std::size_t c = 0; c < count; ++c) {
    const double angle = glm::mix(plan.from, plan.to, static_cast<double>(c) / static_cast<double>(plan.columns));
    std::vector<std::size_t> column;
    std::vector<dvec3> paint;
    const std::vector<HairPoint> points = plan.column(angle);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool top = plan.closed_top && i + 1 == points.size();
      if (!top || c == 0) crown = add_hair_point(skin, points[i].place);
      if (top && c == 0) paint.push_back(points[i].paint);
      column.push_back(top && c > 0 ? columns.front().back() : crown);
      if (!(top && c == 0)) paint.push_back(points[i].paint);
    }
    columns.push_back(std::move(column));
    paints.push_back(std::move(paint));
  }
  for (std::size_t c = 0; c < plan.columns; ++c) {
    const std::size_t next = around ? (c + 1) % count : c + 1;
    for (std::size_t i = 0; i + 1 < columns[c].size(); ++i) {
      std::vector<std::size_t> corners{columns[c][i], columns[next][i], columns[next][i + 1], columns[c][i + 1]};
      std::vector<dvec3> paint{paints[c][i], paints[next][i], paints[next][i + 1], paints[c][i + 1]};
      if (corners[2] == corners[3]) {
        corners.pop_back();
        paint.pop_back();
      }
      skin.faces.push_back({std::move(corners), plan.region, std::move(paint)});
    }
  }
  return skin;
}

double hairline(double angle) {
  constexpr std::array<mannequin::CurveKey, 10> rows{{{0, 12.75},
                                                      {25, 12.85},
                                                      {48, 12.55},
                                                      {59, 11.6},
                                                      {67, 10.1},
                                                      {81, 9.9},
                                                      {90, 11.0},
                                                      {106, 10.7},
                                                      {118, 7.6},
                                                      {180, 5.0}}};
  return mannequin::open_curve(rows, std::abs(angle));
}

Skin hair_cap(const std::function<double(double)>& low, const std::function<double(double, double)>& thick,
              std::size_t rings, std::size_t columns) {
  HairPlan plan;
  plan.columns = columns;
  plan.column = [&, rings](double angle) {
    std::vector<HairPoint> points;
    const double from = low(angle);
    const auto place = [&](double row, double out) { return head_point(angle, row) + head_normal(angle, row) * out; };
    points.push_back({place(from, -0.003), dvec3(0.55)});
    points.push_back({place(from, 0.45 * thick(angle, from)), strand_paint(angle, 0) * 0.8});
    for (std::size_t ring = 1; ring < rings; ++ring) {
      const double share = static_cast<double>(ring) / static_cast<double>(rings);
      const double row = glm::mix(from + 0.35, head_row::crown, std::pow(share, 0.95));
      points.push_back({place(row, thick(angle, row)), strand_paint(angle, share)});
    }
    points.push_back({head_point(0, head_row::crown) + dvec3(0, thick(0, head_row::crown), 0), dvec3(0.9)});
    return points;
  };
  return hair_surface(plan);
}

Skin hair_tube(const std::vector<dvec3>& places, const std::vector<double>& radii, std::size_t around, Region region) {
  Skin skin;
  std::vector<std::size_t> last;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const dvec3 along = glm::normalize(places[std::min(i + 1, places.size() - 1)] - places[i > 0 ? i - 1 : 0]);
    const dvec3 across = glm::normalize(glm::cross(std::abs(along.z) > 0.9 ? dvec3(0, 1, 0) : dvec3(0, 0, 1), along));
    const dvec3 up = glm::cross(along, across);
    std::vector<std::size_t> ring;
    for (std::size_t k = 0; k < around; ++k) {
      const double turn = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(around);
      ring.push_back(add_hair_point(skin, places[i] + (across * std::cos(turn) + up * std::sin(turn)) * radii[i]));
    }
    for (std::size_t k = 0; k < around && !last.empty(); ++k) {
      const std::size_t next = (k + 1) % around;
      const dvec3 paint = dvec3(k % 2 == 0 ? 0.82 : 0.97);
      skin.faces.push_back({{last[k], last[next], ring[next], ring[k]}, region, std::vector<dvec3>(4, paint)});
    }
    std::vector<std::size_t> end = ring;
    if (i == 0) std::reverse(end.begin(), end.end());
    if (i == 0 || i + 1 == places.size()) {
      skin.faces.push_back({end, region, std::vector<dvec3>(around, dvec3(0.8))});
    }
    last = ring;
  }
  return skin;
}

}  // namespace throng::wardrobe
