#include "engine/anim/agent/blend_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace throng::anim {
namespace {

using Points = std::span<const glm::vec2>;
using Triangle = std::array<std::size_t, 3>;
using Edge = std::array<std::size_t, 2>;

/// Returns twice the area of a triangle, above 0 where it goes round counter-clockwise.
double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Says whether `d` lies inside the circle through the corners of a counter-clockwise triangle, and not merely on it.
bool in_circle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const glm::dvec2 p = a - d, q = b - d, r = c - d;
  const double pp = glm::dot(p, p), qq = glm::dot(q, q), rr = glm::dot(r, r);
  const double inside = pp * (q.x * r.y - q.y * r.x) - qq * (p.x * r.y - p.y * r.x) + rr * (p.x * q.y - p.y * q.x);
  const double largest = std::max({pp, qq, rr});
  return inside > 1e-9 * largest * largest;
}

/// Joins points to triangles, from left to right. `hull` goes round counter-clockwise.
struct Sweep {
  Points points;
  std::vector<Triangle> triangles{};
  std::vector<std::size_t> hull{};  // as long as all points lie on a line: these points, in order

  double area_of(std::size_t a, std::size_t b, std::size_t c) const { return area(points[a], points[b], points[c]); }

  void add(std::size_t point) {
    if (!triangles.empty()) return grow(point);
    const double side = hull.size() < 2 ? 0.0 : area_of(hull[0], hull[1], point);
    if (side == 0.0) return hull.push_back(point);
    if (side < 0.0) std::ranges::reverse(hull);
    for (std::size_t i = 0; i + 1 < hull.size(); ++i) triangles.push_back({hull[i], hull[i + 1], point});
    hull.push_back(point);
  }

  // Joins the point to every edge of the hull that it sees. These follow each other.
  void grow(std::size_t point) {
    const std::size_t count = hull.size();
    const auto sees = [&](std::size_t i) { return area_of(hull[i % count], hull[(i + 1) % count], point) < 0.0; };
    std::size_t first = 0;
    while (first < count && (!sees(first) || sees(first + count - 1))) ++first;
    if (first == count) return;
    std::vector<std::size_t> outer{hull[first], point};
    std::size_t edge = first;
    for (; sees(edge); ++edge) triangles.push_back({hull[edge % count], point, hull[(edge + 1) % count]});
    for (; edge % count != first; ++edge) outer.push_back(hull[edge % count]);
    hull = std::move(outer);
  }
};

/// Turns a triangle so that its corner `i` comes first.
Triangle turned(const Triangle& triangle, std::size_t i) {
  return {triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]};
}

/// Flips the edge between two triangles if they share one and the flip makes them rounder.
bool flip(Points points, Triangle& left, Triangle& right) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [a, b, apex] = turned(left, i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [c, d, other] = turned(right, k);
      if (a != d || b != c || !in_circle(points[a], points[b], points[apex], points[other])) continue;
      if (area(points[apex], points[a], points[other]) <= 0.0) continue;
      if (area(points[apex], points[other], points[b]) <= 0.0) continue;
      left = {apex, a, other};
      right = {apex, other, b};
      return true;
    }
  }
  return false;
}

void make_round(Points points, std::vector<Triangle>& triangles) {
  bool flipped = true;
  for (std::size_t pass = 0; flipped && pass < points.size() * points.size(); ++pass) {
    flipped = false;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t k = i + 1; k < triangles.size(); ++k)
        flipped = flip(points, triangles[i], triangles[k]) || flipped;
    }
  }
}

Status check(Points points) {
  if (points.empty()) return Error{"a blend space has no points: give it one point at least"};
  if (points.size() > BlendPlane::most_points) {
    return Error{"a blend space has " + std::to_string(points.size()) + " points: give it at most " +
                 std::to_string(BlendPlane::most_points)};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) {
      return Error{"point " + std::to_string(i) + " of a blend space lies nowhere: give it finite coordinates"};
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (points[k] != points[i]) continue;
      return Error{"points " + std::to_string(k) + " and " + std::to_string(i) +
                   " of a blend space lie at one place: remove one of them"};
    }
  }
  return Done{};
}

/// Puts the corners that weigh something in the order of their points.
BlendPlane::Shares shares_of(std::span<const BlendPlane::Share> corners, const glm::dvec2& place) {
  BlendPlane::Shares shares{.place = glm::vec2(place)};
  float sum = 0.0F;
  for (const BlendPlane::Share& corner : corners) {
    if (!(corner.weight > 0.0F)) continue;
    std::size_t at = shares.count++;
    for (; at > 0 && shares.of[at - 1].point > corner.point; --at) shares.of[at] = shares.of[at - 1];
    shares.of[at] = corner;
    sum += corner.weight;
  }
  for (std::size_t i = 0; i < shares.count; ++i) shares.of[i].weight /= sum;
  return shares;
}

}  // namespace

Result<BlendPlane> BlendPlane::create(std::span<const glm::vec2> points) {
  if (Status checked = check(points); !checked) return checked.error();
  BlendPlane plane;
  plane.points_.assign(points.begin(), points.end());
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
  });
  Sweep sweep{.points = plane.points_};
  for (const std::size_t point : order) sweep.add(point);
  for (std::size_t i = 0; i + 1 < sweep.hull.size(); ++i) plane.edges_.push_back({sweep.hull[i], sweep.hull[i + 1]});
  if (!sweep.triangles.empty()) plane.edges_.push_back({sweep.hull.back(), sweep.hull.front()});
  make_round(plane.points_, sweep.triangles);
  plane.triangles_ = std::move(sweep.triangles);
  return plane;
}

BlendPlane::Shares BlendPlane::shares(const glm::vec2& place) const {
  const glm::dvec2 at(place);
  const auto point = [&](std::size_t i) { return glm::dvec2(points_[i]); };
  for (const Triangle& triangle : triangles_) {
    const glm::dvec2 a = point(triangle[0]), b = point(triangle[1]), c = point(triangle[2]);
    const double whole = area(a, b, c);
    const glm::dvec3 parts = glm::dvec3(area(b, c, at), area(c, a, at), area(a, b, at)) / whole;
    if (parts.x < 0.0 || parts.y < 0.0 || parts.z < 0.0) continue;
    const std::array<Share, 3> corners{{{triangle[0], static_cast<float>(parts.x)},
                                        {triangle[1], static_cast<float>(parts.y)},
                                        {triangle[2], static_cast<float>(parts.z)}}};
    return shares_of(corners, at);
  }
  std::array<Share, 2> nearest{{{0, 1.0F}, {0, 0.0F}}};
  glm::dvec2 nearest_place = point(0);
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_) {
    const glm::dvec2 from = point(edge[0]), along = point(edge[1]) - from;
    const double way = glm::clamp(glm::dot(at - from, along) / glm::dot(along, along), 0.0, 1.0);
    const glm::dvec2 there = from + way * along;
    const double distance = glm::distance(there, at);
    if (distance >= least) continue;
    least = distance;
    nearest_place = there;
    nearest = {{{edge[0], static_cast<float>(1.0 - way)}, {edge[1], static_cast<float>(way)}}};
  }
  return shares_of(nearest, nearest_place);
}

}  // namespace throng::anim
