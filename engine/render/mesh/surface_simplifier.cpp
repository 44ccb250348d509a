#include "engine/render/mesh/surface_simplifier.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::render {
namespace {

constexpr std::uint32_t no_vertex = UINT32_MAX;

// A bent joint moves the surface around it by about this share of the size of the character.
constexpr double joint_travel_share = 0.05;

// A colour that is lost altogether counts as a surface that moved by this share of the size of the character.
constexpr double color_travel_share = 0.03;

// The length of an edge costs this much: of merges that keep the shape, short ones make better triangles.
constexpr double length_cost = 1e-3;

// Vertices whose texture coordinates are this close show the same colour: they are two sides of a hard edge, or lie in
// one patch of an atlas of plain colours.
constexpr float like_texture = 1.0F / 64.0F;

// A triangle may tilt by up to about 75 degrees in one merge.
constexpr double least_cosine = 0.25;

}  // namespace

SurfaceSimplifier::SurfaceSimplifier(const SkinnedSurfaceView& surface) : surface_(surface) {
  join_vertices_into_points();
  add_triangles();
  hold_open_edges();
}

void SurfaceSimplifier::join_vertices_into_points() {
  std::map<std::tuple<float, float, float>, std::uint32_t> point_at;
  constexpr double far = std::numeric_limits<double>::infinity();
  glm::dvec3 low(far), high(-far);
  for (std::uint32_t vertex = 0; vertex < surface_.influences.size(); ++vertex) {
    const float* p = &surface_.positions[vertex * 3UL];
    const auto [found, is_new] = point_at.try_emplace({p[0], p[1], p[2]}, static_cast<std::uint32_t>(points_.size()));
    if (is_new) {
      points_.push_back({glm::dvec3(p[0], p[1], p[2]), surface_.influences[vertex], {}, {}, {}, 0, false});
      low = glm::min(low, points_.back().position);
      high = glm::max(high, points_.back().position);
    }
    points_[found->second].vertices.push_back(vertex);
    point_of_vertex_.push_back(found->second);
  }
  const glm::dvec3 extent = high - low;
  const double largest = std::max({extent.x, extent.y, extent.z, 0.0});
  joint_travel_ = joint_travel_share * largest;
  color_travel_ = color_travel_share * largest;
  if (!surface_.colors.empty()) painted_.resize(surface_.colors.size());
}

double SurfaceSimplifier::firmness(std::uint32_t vertex) const {
  return !surface_.face.empty() && surface_.face[vertex] != 0 ? surface_.face_firmness : 1.0;
}

void SurfaceSimplifier::add_triangles() {
  for (std::size_t i = 0; i + 2 < surface_.indices.size(); i += 3) {
    const Triangle triangle = {surface_.indices[i], surface_.indices[i + 1], surface_.indices[i + 2]};
    const glm::dvec3 normal_and_area = normal(triangle);
    const double twice_area = glm::length(normal_and_area);
    if (twice_area == 0.0) continue;
    const auto index = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(triangle);
    for (const std::uint32_t vertex : triangle) {
      Point& point = points_[point_of_vertex_[vertex]];
      point.triangles.push_back(index);
      const double area = firmness(vertex) * twice_area / 6.0;
      point.cost.add_plane(normal_and_area / twice_area, point.position, area);
      point.cost.add_influences(point.influences, area);
      if (!painted_.empty()) painted_[vertex].add(surface_.colors[vertex], area);
    }
  }
  triangle_count_ = triangles_.size();
  removed_.assign(triangles_.size(), false);
}

/// Gives each edge that has a triangle on one side only a plane upright on that triangle, so that hems stay in place.
void SurfaceSimplifier::hold_open_edges() {
  std::map<Edge, int> sides;
  for (const Triangle& triangle : triangles_) {
    for (std::size_t corner = 0; corner < 3; ++corner) ++sides[edge_of(triangle, corner)];
  }
  for (const Triangle& triangle : triangles_) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Edge edge = edge_of(triangle, corner);
      if (sides.at(edge) != 1) continue;
      const glm::dvec3 along = points_[edge.second].position - points_[edge.first].position;
      const glm::dvec3 upright = glm::normalize(glm::cross(along, normal(triangle)));
      for (const std::uint32_t end : {edge.first, edge.second}) {
        points_[end].cost.add_plane(upright, points_[end].position,
                                    surface_.open_edge_firmness * glm::dot(along, along));
      }
    }
  }
}

SurfaceSimplifier::Edge SurfaceSimplifier::edge_of(const Triangle& triangle, std::size_t corner) const {
  return std::minmax({point_of_vertex_[triangle.at(corner)], point_of_vertex_[triangle.at((corner + 1) % 3)]});
}

void SurfaceSimplifier::reduce_to(std::size_t triangles, double largest_error) {
  // Starts from all points again: a merge that was refused for a smaller error may be allowed now.
  merges_ = {};
  for (std::uint32_t point = 0; point < points_.size(); ++point) propose_merges_around(point);
  StandIns stand_ins;
  while (triangle_count_ > triangles && !merges_.empty()) {
    const Merge next = merges_.top();
    merges_.pop();
    if (!is_current(next)) continue;
    const double moved = std::sqrt(points_[next.from].cost.squared_distance(points_[next.into].position));
    if (moved > largest_error || pinches(next.from, next.into) || turns_a_triangle_over(next.from, next.into) ||
        !find_stand_ins(next.from, next.into, stand_ins)) {
      continue;
    }
    error_ = std::max(error_, moved);
    merge(next.from, next.into, stand_ins);
  }
}

std::vector<std::uint32_t> SurfaceSimplifier::indices() const {
  std::vector<std::uint32_t> left;
  left.reserve(triangle_count_ * 3);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    if (!removed_[i]) left.insert(left.end(), triangles_[i].begin(), triangles_[i].end());
  }
  return left;
}

void SurfaceSimplifier::propose_merges_around(std::uint32_t point) {
  const Point& from = points_[point];
  for (const std::uint32_t neighbour : neighbours(point)) {
    const Point& into = points_[neighbour];
    const glm::dvec3 edge = into.position - from.position;
    const double cost = from.cost.at(into.position, into.influences, joint_travel_) + color_cost(from, into);
    const double length = length_cost * glm::dot(edge, edge) * glm::dot(edge, edge);
    merges_.push({cost + length, point, neighbour, from.version});
  }
}

/// Returns the cost if each vertex of a point takes the colour of the vertex of the other point that is most like
/// it.
double SurfaceSimplifier::color_cost(const Point& from, const Point& into) const {
  if (painted_.empty()) return 0.0;
  double cost = 0.0;
  for (const std::uint32_t vertex : from.vertices) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t other : into.vertices) {
      if (surface_.belongs_to[other] != surface_.belongs_to[vertex]) continue;
      least = std::min(least, painted_[vertex].at(surface_.colors[other]));
    }
    // Where there is none, find_stand_ins decides.
    if (least < std::numeric_limits<double>::infinity()) cost += least;
  }
  return color_travel_ * color_travel_ * cost;
}

bool SurfaceSimplifier::is_current(const Merge& merge) const {
  const Point& from = points_[merge.from];
  if (from.merged_away || points_[merge.into].merged_away || from.version != merge.version) return false;
  return std::ranges::any_of(from.triangles,
                             [&](std::uint32_t triangle) { return has_point(triangles_[triangle], merge.into); });
}

bool SurfaceSimplifier::turns_a_triangle_over(std::uint32_t from, std::uint32_t into) const {
  for (const std::uint32_t index : points_[from].triangles) {
    const Triangle& triangle = triangles_[index];
    if (has_point(triangle, into)) continue;
    std::array<glm::dvec3, 3> corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t point = point_of_vertex_[triangle.at(corner)];
      corners.at(corner) = points_[point == from ? into : point].position;
    }
    const glm::dvec3 before = normal(triangle);
    const glm::dvec3 after = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (glm::dot(before, after) <= least_cosine * glm::length(before) * glm::length(after)) return true;
  }
  return false;
}

/// Says whether the merge would glue two sheets together. It would if a point is next to both ends of the edge and no
/// triangle at the edge has it.
bool SurfaceSimplifier::pinches(std::uint32_t from, std::uint32_t into) const {
  std::vector<std::uint32_t> common;
  std::ranges::set_intersection(neighbours(from), neighbours(into), std::back_inserter(common));
  const auto at_edge = std::ranges::count_if(
      points_[from].triangles, [&](std::uint32_t triangle) { return has_point(triangles_[triangle], into); });
  return common.size() > static_cast<std::size_t>(at_edge);
}

bool SurfaceSimplifier::find_stand_ins(std::uint32_t from, std::uint32_t into, StandIns& stand_ins) const {
  stand_ins.clear();
  // The vertices that a vanishing triangle has at both ends of the edge belong together.
  for (const std::uint32_t index : points_[from].triangles) {
    const Triangle& triangle = triangles_[index];
    if (!has_point(triangle, into)) continue;
    const auto at = [&](std::uint32_t point) {
      return *std::ranges::find_if(triangle, [&](std::uint32_t vertex) { return point_of_vertex_[vertex] == point; });
    };
    stand_ins.emplace_back(at(from), at(into));
  }
  for (const std::uint32_t vertex : points_[from].vertices) {
    if (std::ranges::find(stand_ins, vertex, &StandIns::value_type::first) != stand_ins.end()) continue;
    const auto alike =
        std::ranges::find_if(stand_ins, [&](const auto& paired) { return looks_like(paired.first, vertex); });
    const std::uint32_t stand_in = alike != stand_ins.end() ? alike->second : stand_in_elsewhere(vertex, points_[into]);
    if (stand_in == no_vertex) return false;
    stand_ins.emplace_back(vertex, stand_in);
  }
  return true;
}

std::uint32_t SurfaceSimplifier::stand_in_elsewhere(std::uint32_t vertex, const Point& into) const {
  const auto found =
      std::ranges::find_if(into.vertices, [&](std::uint32_t candidate) { return looks_like(candidate, vertex); });
  return found == into.vertices.end() ? no_vertex : *found;
}

bool SurfaceSimplifier::looks_like(std::uint32_t vertex, std::uint32_t other) const {
  if (surface_.belongs_to[vertex] != surface_.belongs_to[other]) return false;
  if (surface_.texture_coords.empty()) return true;
  const float* one = &surface_.texture_coords[vertex * 2UL];
  const float* its = &surface_.texture_coords[other * 2UL];
  return std::abs(its[0] - one[0]) <= like_texture && std::abs(its[1] - one[1]) <= like_texture;
}

void SurfaceSimplifier::merge(std::uint32_t from, std::uint32_t into, const StandIns& stand_ins) {
  Point& gone = points_[from];
  Point& kept = points_[into];
  const std::vector<std::uint32_t> around = std::exchange(gone.triangles, {});
  for (const std::uint32_t index : around) {
    Triangle& triangle = triangles_[index];
    if (has_point(triangle, into)) {
      removed_[index] = true;
      --triangle_count_;
      for (const std::uint32_t vertex : triangle) std::erase(points_[point_of_vertex_[vertex]].triangles, index);
      continue;
    }
    for (std::uint32_t& vertex : triangle) {
      const auto stand_in = std::ranges::find(stand_ins, vertex, &StandIns::value_type::first);
      if (stand_in != stand_ins.end()) vertex = stand_in->second;
    }
    kept.triangles.push_back(index);
  }
  gone.merged_away = true;
  kept.cost.add(gone.cost);
  for (const std::uint32_t vertex : gone.vertices) {
    const auto stand_in = std::ranges::find(stand_ins, vertex, &StandIns::value_type::first);
    if (!painted_.empty()) painted_[stand_in->second].add(painted_[vertex]);
  }
  ++kept.version;
  propose_merges_around(into);
  for (const std::uint32_t neighbour : neighbours(into)) propose_merges_around(neighbour);
}

bool SurfaceSimplifier::has_point(const Triangle& triangle, std::uint32_t point) const {
  return std::ranges::any_of(triangle, [&](std::uint32_t vertex) { return point_of_vertex_[vertex] == point; });
}

std::vector<std::uint32_t> SurfaceSimplifier::neighbours(std::uint32_t point) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t triangle : points_[point].triangles) {
    for (const std::uint32_t vertex : triangles_[triangle]) found.push_back(point_of_vertex_[vertex]);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::erase(found, point);
  return found;
}

glm::dvec3 SurfaceSimplifier::normal(const Triangle& triangle) const {
  const auto at = [&](std::size_t corner) { return points_[point_of_vertex_[triangle.at(corner)]].position; };
  return glm::cross(at(1) - at(0), at(2) - at(0));
}

}  // namespace throng::render
