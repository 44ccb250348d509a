#include "app/people/place/plan_cover.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"

namespace throng::app {
namespace {

// Plans are full of lines along their axes. Turned by an angle that no plan has, no line lies level.
constexpr double turn_cosine = 0.8253356149096783, turn_sine = 0.5646424733950354;  // 0.6 radians
constexpr double same_place = 1e-7;                                                 // metres
constexpr double same_height = 1e-9;
constexpr std::uint32_t no_polygon = 0xFFFFFFFF;  // a column's line
// This many take a second on a slow core. Lines that cross more often are no plan.
constexpr std::size_t most_comparisons = 100'000'000, most_crossings = 30'000'000;

glm::dvec2 turned(const glm::dvec2& at) {
  return {turn_cosine * at.x - turn_sine * at.y, turn_sine * at.x + turn_cosine * at.y};
}

glm::dvec2 turned_back(const glm::dvec2& at) {
  return {turn_cosine * at.x + turn_sine * at.y, turn_cosine * at.y - turn_sine * at.x};
}

glm::dvec2 left_of(const glm::dvec2& way) { return {-way.y, way.x}; }

/// Counts the polygons of each layer that a point lies in, from the left to the right.
class Inside {
 public:
  explicit Inside(std::span<const CoverLayer> layers) : layers_(layers), is_in_(layers.size()) {}

  void cross_line_of(std::uint32_t polygon) {
    is_in_[polygon] = !is_in_[polygon];
    counts_.at(static_cast<std::size_t>(layers_[polygon])) += is_in_[polygon] ? 1 : -1;
  }
  std::array<bool, cover_part_count> parts() const {
    const bool floor = has(CoverLayer::floor), solid = has(CoverLayer::solid), exit = has(CoverLayer::exit);
    return {solid || (has(CoverLayer::border) && !floor && !exit), floor && !solid, exit};
  }

 private:
  bool has(CoverLayer layer) const { return counts_.at(static_cast<std::size_t>(layer)) > 0; }

  std::span<const CoverLayer> layers_;
  std::vector<bool> is_in_;
  std::array<int, cover_layer_count> counts_{};
};

}  // namespace

std::vector<DoubleRing> rings_of(const GroundArea& area) {
  std::vector<DoubleRing> rings{doubled(area.outline)};
  for (const GroundRing& hole : area.holes) rings.push_back(doubled(hole));
  return rings;
}

glm::dvec2 cover_direction() { return turned_back({1.0, 0.0}); }

double PlanCover::Edge::x_at(double y) const {
  const double share = std::clamp((y - low.y) / (high.y - low.y), 0.0, 1.0);
  return low.x + share * (high.x - low.x);
}

void PlanCover::add_ring(std::span<const glm::dvec2> ring) {
  const auto polygon = static_cast<std::uint32_t>(layers_.size() - 1);
  for (std::size_t corner = 0; corner < ring.size(); ++corner) {
    glm::dvec2 low = turned(ring[corner]), high = turned(ring[(corner + 1) % ring.size()]);
    if (low.y > high.y) std::swap(low, high);
    if (low.y < high.y) edges_.push_back({low, high, polygon});
  }
}

void PlanCover::add(CoverLayer layer, std::span<const std::vector<glm::dvec2>> rings) {
  layers_.push_back(layer);
  for (const std::vector<glm::dvec2>& ring : rings) add_ring(ring);
}

void PlanCover::add_convex(CoverLayer layer, std::span<const glm::dvec2> ring) {
  layers_.push_back(layer);
  add_ring(ring);
}

// Fills the gap between the walls of two lines, on the outer side of the corner between them.
void PlanCover::add_corner(CoverLayer layer, const std::array<glm::dvec2, 3>& points, double half_width) {
  constexpr double sharpest = -0.5;  // the cosine of the turn, beyond which a corner would reach out far
  const glm::dvec2 in = glm::normalize(points[1] - points[0]), out = glm::normalize(points[2] - points[1]);
  const double outer = cross(in, out) > 0.0 ? -half_width : half_width, cosine = glm::dot(in, out);
  const glm::dvec2 first = points[1] + outer * left_of(in), last = points[1] + outer * left_of(out);
  const glm::dvec2 tip = points[1] + outer * (left_of(in) + left_of(out)) / (1.0 + std::max(cosine, sharpest));
  if (cosine > sharpest) {
    add_convex(layer, std::array{points[1], first, tip, last});
  } else {
    add_convex(layer, std::array{points[1], first, last});
  }
}

void PlanCover::add_band(CoverLayer layer, std::span<const glm::dvec2> line, bool is_closed, double half_width) {
  std::vector<glm::dvec2> points;
  for (const glm::dvec2& point : line) {
    if (points.empty() || glm::distance(points.back(), point) > same_place) points.push_back(point);
  }
  while (is_closed && points.size() > 1 && glm::distance(points.front(), points.back()) <= same_place) {
    points.pop_back();
  }
  const std::size_t count = points.size(), closing = is_closed && count > 2 ? count : count - 1;
  if (count < 2) return;
  for (std::size_t i = 0; i < closing; ++i) {
    const glm::dvec2 &from = points[i], &to = points[(i + 1) % count];
    const glm::dvec2 aside = half_width * left_of(glm::normalize(to - from));
    add_convex(layer, std::array{from - aside, to - aside, to + aside, from + aside});
    if (i + 1 == closing && closing < count) break;  // the end of an open line
    add_corner(layer, {from, to, points[(i + 2) % count]}, half_width);
  }
}

void PlanCover::cut_columns(double width) {
  constexpr double most_columns = 400.0;
  if (edges_.empty()) return;
  glm::dvec2 lowest = edges_.front().low, highest = edges_.front().high;
  for (const Edge& edge : edges_) {
    lowest = glm::min(lowest, glm::min(edge.low, edge.high));
    highest = glm::max(highest, glm::max(edge.low, edge.high));
  }
  width = std::max(width, (highest.x - lowest.x) / most_columns);
  for (double x = lowest.x + width; x < highest.x; x += width) {
    edges_.push_back({{x, lowest.y}, {x, highest.y}, no_polygon});
  }
}

// Returns the heights at which a line begins, ends or meets another one, ascending; none if there are too many.
std::vector<double> PlanCover::events() const {
  std::vector<double> heights;
  std::vector<const Edge*> order, active;
  std::size_t comparisons = 0;
  for (const Edge& edge : edges_) order.push_back(&edge);
  std::ranges::sort(order, {}, [](const Edge* edge) { return edge->low.y; });
  for (const Edge* edge : order) {
    heights.insert(heights.end(), {edge->low.y, edge->high.y});
    std::erase_if(active, [&](const Edge* other) { return other->high.y <= edge->low.y; });
    comparisons += active.size();
    if (comparisons > most_comparisons || heights.size() > most_crossings) return {};
    const auto [least, most] = std::minmax(edge->low.x, edge->high.x);
    const glm::dvec2 way = edge->high - edge->low;
    for (const Edge* other : active) {
      if (std::max(other->low.x, other->high.x) < least || std::min(other->low.x, other->high.x) > most) continue;
      const glm::dvec2 other_way = other->high - other->low;
      const double turn = cross(way, other_way), share = cross(other->low - edge->low, other_way) / turn;
      const double other_share = cross(other->low - edge->low, way) / turn;
      const bool meets = share > 0.0 && share < 1.0 && other_share > 0.0 && other_share < 1.0;  // not where turn is 0
      if (meets) heights.push_back(edge->low.y + share * way.y);
    }
    active.push_back(edge);
  }
  std::ranges::sort(heights);
  const auto is_same = [](double a, double b) { return b - a < same_height; };
  heights.erase(std::unique(heights.begin(), heights.end(), is_same), heights.end());
  return heights;
}

// Goes from the left to the right over the lines of a strip, and adds a piece for each stretch of a part.
void PlanCover::cut(std::span<const Crossing> crossings, double from, std::vector<OpenPiece>& pieces) const {
  Inside inside(layers_);
  std::array<std::optional<PieceSide>, cover_part_count> begun;
  for (std::size_t i = 0; i < crossings.size();) {
    const Crossing first = crossings[i];
    bool is_column = false;
    for (; i < crossings.size() && crossings[i].x - first.x <= same_place; ++i) {
      const std::uint32_t polygon = edges_[crossings[i].edge].polygon;
      if (polygon == no_polygon) is_column = true;
      if (polygon != no_polygon) inside.cross_line_of(polygon);
    }
    const std::array<bool, cover_part_count> parts = inside.parts();
    for (std::size_t part = 0; part < cover_part_count; ++part) {
      std::optional<PieceSide>& left = begun.at(part);
      const PieceSide side{first.edge, parts.at(part) != left.has_value()};
      if (!side.is_outline && !is_column) continue;
      if (left) pieces.push_back({static_cast<CoverPart>(part), *left, side, from});
      left = parts.at(part) ? std::optional(side) : std::nullopt;
    }
  }
}

CoverPiece PlanCover::closed(const OpenPiece& piece, double to) const {
  const auto side = [&](const Edge& edge) {
    return std::array{turned_back({edge.x_at(piece.from), piece.from}), turned_back({edge.x_at(to), to})};
  };
  return {piece.part, side(edges_[piece.left.edge]), side(edges_[piece.right.edge]), piece.left.is_outline,
          piece.right.is_outline};
}

std::vector<CoverPiece> PlanCover::pieces() const {
  const auto key = [](const OpenPiece& piece) { return std::tuple(piece.part, piece.left, piece.right); };
  std::vector<CoverPiece> made;
  std::vector<OpenPiece> open, next;
  std::vector<Crossing> crossings;
  std::vector<std::uint32_t> order(edges_.size()), active;
  for (std::uint32_t edge = 0; edge < order.size(); ++edge) order[edge] = edge;
  std::ranges::sort(order, {}, [&](std::uint32_t edge) { return edges_[edge].low.y; });
  const std::vector<double> heights = events();
  std::size_t begun = 0, work = 0;
  for (std::size_t strip = 0; strip + 1 < heights.size(); ++strip) {
    const double middle = 0.5 * (heights[strip] + heights[strip + 1]);
    while (begun < order.size() && edges_[order[begun]].low.y <= middle) active.push_back(order[begun++]);
    std::erase_if(active, [&](std::uint32_t edge) { return edges_[edge].high.y <= middle; });
    work += active.size();
    if (work > most_crossings) return {};
    crossings.clear();
    for (const std::uint32_t edge : active) crossings.push_back({edges_[edge].x_at(middle), edge});
    std::ranges::sort(crossings, {}, [](const Crossing& at) { return std::pair(at.x, at.edge); });
    next.clear();
    cut(crossings, heights[strip], next);
    std::ranges::sort(next, {}, key);
    for (const OpenPiece& piece : open) {
      const auto same = std::ranges::lower_bound(next, key(piece), {}, key);
      if (same != next.end() && key(*same) == key(piece)) {
        same->from = piece.from;  // the piece goes on between the same lines
      } else {
        made.push_back(closed(piece, heights[strip]));
      }
    }
    open.swap(next);
  }
  for (const OpenPiece& piece : open) made.push_back(closed(piece, heights.back()));
  return made;
}

}  // namespace throng::app
