#include "assets/wardrobe/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/skeleton.h"

namespace throng::wardrobe {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double whole_turn = 2 * std::numbers::pi;

/// Eight corners around a rounded rectangle, anticlockwise seen from +y.
std::vector<dvec2> rounded_rectangle(dvec2 half, double bevel) {
  const dvec2 inner = half - dvec2(bevel);
  return {{half.x, -inner.y}, {inner.x, -half.y}, {-inner.x, -half.y}, {-half.x, -inner.y},
          {-half.x, inner.y}, {-inner.x, half.y}, {inner.x, half.y},   {half.x, inner.y}};
}

}  // namespace

Frame Frame::turned(dvec3 x, dvec3 y) const {
  const dvec3 first = glm::normalize(x);
  const dvec3 second = glm::normalize(y - first * glm::dot(first, y));
  return {origin, axes * glm::dmat3(first, second, glm::cross(first, second))};
}

Frame right_hand() {
  const auto mirrored = [](dvec3 v) { return dvec3(-v.x, v.y, v.z); };
  const mannequin::ArmFrame& arm = mannequin::left_arm();
  return {mirrored(arm.at(mannequin::wrist_distance)),
          glm::dmat3(mirrored(arm.thumbwards), mirrored(arm.along), mirrored(-arm.backwards))};
}

std::size_t Solids::add(dvec3 place) { return add(place, weights_); }

std::size_t Solids::add(dvec3 place, const mannequin::Weights& weights) {
  const dvec3 stepped = glm::round(place / mannequin::position_step) * mannequin::position_step + dvec3(0);
  skin_.points.push_back({.position = stepped, .normal = dvec3(0), .weights = weights});
  return skin_.points.size() - 1;
}

void Solids::face(std::vector<std::size_t> corners) {
  const std::size_t count = corners.size();
  skin_.faces.push_back({.corners = std::move(corners),
                         .region = coat.region,
                         .paint = std::vector<dvec3>(count, coat.paint),
                         .notes = {.trim = coat.trim, .chart = mannequin::Chart::from_side}});
}

void Solids::box(const Frame& frame, dvec3 size, double bevel, dvec2 taper) {
  const dvec3 half = 0.5 * size;
  const double in = bevel * 0.7;
  struct Section {
    double height, inset;
  };
  const std::array<Section, 4> sections{{{-half.y, in}, {-half.y + in, 0}, {half.y - in, 0}, {half.y, in}}};
  std::vector<std::vector<std::size_t>> rings;
  for (const Section& section : sections) {
    const double up = 0.5 + 0.5 * section.height / half.y;
    const dvec2 scale = dvec2(1) + (taper - dvec2(1)) * up;
    std::vector<std::size_t> ring;
    for (const dvec2 corner : rounded_rectangle(dvec2(half.x, half.z) * scale - dvec2(section.inset), bevel)) {
      ring.push_back(add(frame.at({corner.x, section.height, corner.y})));
    }
    rings.push_back(std::move(ring));
  }
  for (std::size_t s = 0; s + 1 < rings.size(); ++s) {
    for (std::size_t c = 0; c < 8; ++c) {
      const std::size_t next = (c + 1) % 8;
      face({rings[s][c], rings[s][next], rings[s + 1][next], rings[s + 1][c]});
    }
  }
  face({rings.front().rbegin(), rings.front().rend()});
  face({rings.back().begin(), rings.back().end()});
}

void Solids::turn(const Frame& frame, std::span<const dvec2> outline, std::size_t around) {
  std::vector<std::vector<std::size_t>> rings;
  for (const dvec2 point : outline) {
    std::vector<std::size_t> ring;
    const bool is_pole = point.x < 1e-6;
    for (std::size_t i = 0; i < (is_pole ? 1 : around); ++i) {
      const double angle = whole_turn * static_cast<double>(i) / static_cast<double>(around);
      ring.push_back(add(frame.at({point.x * std::cos(angle), point.y, -point.x * std::sin(angle)})));
    }
    rings.push_back(std::move(ring));
  }
  for (std::size_t s = 0; s + 1 < rings.size(); ++s) {
    const auto& low = rings[s];
    const auto& high = rings[s + 1];
    for (std::size_t i = 0; i < around; ++i) {
      const std::size_t next = (i + 1) % around;
      if (low.size() == 1 && high.size() == 1) continue;
      if (low.size() == 1) {
        face({low[0], high[next], high[i]});
      } else if (high.size() == 1) {
        face({low[i], low[next], high[0]});
      } else {
        face({low[i], low[next], high[next], high[i]});
      }
    }
  }
  if (rings.front().size() > 1) face({rings.front().rbegin(), rings.front().rend()});
  if (rings.back().size() > 1) face({rings.back().begin(), rings.back().end()});
}

void Solids::rod(const Frame& frame, std::span<const dvec3> way, double radius, std::size_t around) {
  std::vector<std::vector<std::size_t>> rings;
  dvec3 side(0);
  for (std::size_t i = 0; i < way.size(); ++i) {
    const dvec3 along = glm::normalize(way[std::min(i + 1, way.size() - 1)] - way[i > 0 ? i - 1 : 0]);
    const dvec3 hint = i == 0 ? (std::abs(along.z) < 0.8 ? dvec3(0, 0, 1) : dvec3(1, 0, 0)) : side;
    side = glm::normalize(hint - along * glm::dot(hint, along));
    const dvec3 other = glm::cross(along, side);
    std::vector<std::size_t> ring;
    for (std::size_t a = 0; a < around; ++a) {
      const double angle = whole_turn * static_cast<double>(a) / static_cast<double>(around);
      ring.push_back(add(frame.at(way[i] + radius * (std::cos(angle) * side + std::sin(angle) * other))));
    }
    rings.push_back(std::move(ring));
  }
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    for (std::size_t a = 0; a < around; ++a) {
      const std::size_t next = (a + 1) % around;
      face({rings[i][a], rings[i][next], rings[i + 1][next], rings[i + 1][a]});
    }
  }
  face({rings.front().rbegin(), rings.front().rend()});
  face({rings.back().begin(), rings.back().end()});
}

void Solids::strap(std::span<const dvec3> way, std::span<const dvec3> across, double breadth, double thickness,
                   const std::function<mannequin::Weights(dvec3)>& weights) {
  std::vector<std::array<std::size_t, 4>> rings;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const dvec3 along = glm::normalize(way[std::min(i + 1, way.size() - 1)] - way[i > 0 ? i - 1 : 0]);
    const dvec3 wide = glm::normalize(across[i] - along * glm::dot(across[i], along));
    const dvec3 out = glm::cross(along, wide);
    const mannequin::Weights bound = weights(way[i]);
    const dvec3 w = 0.5 * breadth * wide;
    const dvec3 t = 0.5 * thickness * out;
    rings.push_back({add(way[i] + w - t, bound), add(way[i] + w + t, bound), add(way[i] - w + t, bound),
                     add(way[i] - w - t, bound)});
  }
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    for (std::size_t a = 0; a < 4; ++a) {
      const std::size_t next = (a + 1) % 4;
      face({rings[i][a], rings[i][next], rings[i + 1][next], rings[i + 1][a]});
    }
  }
  face({rings.front().rbegin(), rings.front().rend()});
  face({rings.back().begin(), rings.back().end()});
}

void Solids::cloth(const Frame& frame, std::size_t columns, std::size_t rows,
                   const std::function<dvec3(double, double)>& place) {
  constexpr double thickness = 0.003;
  constexpr double near = 1e-3;
  // Places that coincide, where a grid closes or ends in a point, are one vertex.
  std::vector<std::size_t> grid;
  std::vector<std::array<std::size_t, 2>> sides;  // the vertex of each side
  std::vector<dvec3> places;
  for (std::size_t r = 0; r <= rows; ++r) {
    for (std::size_t c = 0; c <= columns; ++c) {
      const double u = static_cast<double>(c) / static_cast<double>(columns);
      const double v = static_cast<double>(r) / static_cast<double>(rows);
      const dvec3 at = place(u, v);
      const auto same =
          std::find_if(places.begin(), places.end(), [&](dvec3 p) { return glm::distance(p, at) < near; });
      grid.push_back(static_cast<std::size_t>(same - places.begin()));
      if (same != places.end()) continue;
      const double inner = std::clamp(v, 0.02, 0.98);
      const dvec3 across = place(u + 1e-4, inner) - place(u - 1e-4, inner);
      const dvec3 along = place(u, inner + 1e-4) - place(u, inner - 1e-4);
      const dvec3 half = 0.5 * thickness * glm::normalize(glm::cross(across, along));
      places.push_back(at);
      sides.push_back({add(frame.at(at + half)), add(frame.at(at - half))});
    }
  }
  std::set<std::array<std::size_t, 2>> edges;
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t a = r * (columns + 1) + c;
      std::vector<std::size_t> quad;
      for (const std::size_t corner : {grid[a], grid[a + 1], grid[a + columns + 2], grid[a + columns + 1]}) {
        if (std::find(quad.begin(), quad.end(), corner) == quad.end()) quad.push_back(corner);
      }
      if (quad.size() < 3) continue;
      std::vector<std::size_t> front, back;
      for (std::size_t k = 0; k < quad.size(); ++k) {
        front.push_back(sides[quad[k]][0]);
        back.push_back(sides[quad[quad.size() - 1 - k]][1]);
        edges.insert({quad[k], quad[(k + 1) % quad.size()]});
      }
      face(front);
      face(back);
    }
  }
  for (const auto& [a, b] : edges) {
    if (edges.contains({b, a})) continue;
    std::vector<std::size_t> wall;  // has vertices of its own, so that the cloth's edge is sharp
    for (const std::size_t corner : {sides[b][0], sides[a][0], sides[a][1], sides[b][1]}) {
      wall.push_back(add(dvec3(skin_.points[corner].position)));
    }
    face(wall);
  }
}

}  // namespace throng::wardrobe
