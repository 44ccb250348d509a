#include "app/people/measure/walkable_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"
#include "app/people/place/plan_cover.h"

namespace throng::app {
namespace {

constexpr double wall_half_width = 1e-3;    // metres
constexpr double narrowest_opening = 2e-3;  // metres: narrower gaps are between lines that ought to meet
constexpr double same_level = 1e-7;         // metres
constexpr double floor_margin = 20'000;     // metres from the obstacles, where a plan has no floor
constexpr double square = 2.0;              // metres
constexpr double most_squares = 200'000;
constexpr std::uint32_t no_piece = 0xFFFFFFFF;

struct Box {
  glm::dvec2 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};

  void add(std::span<const glm::dvec2> points) {
    for (const glm::dvec2& point : points) low = glm::min(low, point), high = glm::max(high, point);
  }
};

/// Returns a floor that holds all people around the obstacles.
DoubleRing floor_around(const GroundPlan& plan) {
  Box box;
  for (const GroundRing& ring : plan.obstacles) box.add(doubled(ring));
  for (const GroundLine& line : plan.walls) box.add(doubled(line.points));
  const glm::dvec2 low = box.low - floor_margin, high = box.high + floor_margin;
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

bool holds(std::span<const glm::dvec2> corners, const glm::dvec2& place) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &from = corners[i], &to = corners[i + 1 < corners.size() ? i + 1 : 0];
    if (cross(to - from, place - from) < 0.0) return false;
  }
  return true;
}

/// Returns how far a place lies from the edge of a piece.
double distance_to(std::span<const glm::dvec2> corners, const glm::dvec2& place) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &from = corners[i], way = corners[(i + 1) % corners.size()] - from;
    const double length_squared = glm::dot(way, way);
    const double share =
        length_squared > 0.0 ? std::clamp(glm::dot(place - from, way) / length_squared, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::distance(place, from + share * way));
  }
  return least;
}

/// Returns the length of a line within a cell.
float length_within(const ConvexPolygon& cell, glm::vec2 from, glm::vec2 to) {
  const std::span<const glm::vec2> corners = cell.corners();
  float begin = 0.0F, end = 1.0F;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::vec2 side = corners[(i + 1) % corners.size()] - corners[i];
    const auto inside = [&](const glm::vec2& place) { return cross(side, place - corners[i]); };
    const float first = inside(from), last = inside(to);
    if (first < 0.0F && last < 0.0F) return 0.0F;
    if (first < 0.0F) begin = std::max(begin, first / (first - last));
    if (last < 0.0F) end = std::min(end, first / (first - last));
  }
  return end > begin ? (end - begin) * glm::distance(from, to) : 0.0F;
}

}  // namespace

WalkableArea::WalkableArea(const GroundPlan& plan) {
  if (plan.floors.empty() && plan.obstacles.empty() && plan.walls.empty()) return;
  take_pieces(plan);
  if (pieces_.empty()) return;
  join_pieces();
  sort_into_squares();
}

void WalkableArea::take_pieces(const GroundPlan& plan) {
  PlanCover cover;
  if (plan.floors.empty()) cover.add(CoverLayer::floor, std::array{floor_around(plan)});
  for (const GroundArea& floor : plan.floors) cover.add(CoverLayer::floor, rings_of(floor));
  for (const GroundRing& ring : plan.obstacles) cover.add(CoverLayer::solid, std::array{doubled(ring)});
  for (const GroundLine& wall : plan.walls) {
    cover.add_band(CoverLayer::solid, doubled(wall.points), false, wall_half_width);
  }
  for (const CoverPiece& piece : cover.pieces()) {
    if (piece.part != CoverPart::floor) continue;
    pieces_.push_back({.corners = {piece.left[0], piece.right[0], piece.right[1], piece.left[1]}});
  }
}

// Pieces begin and end at level lines. Where one piece ends and another begins at the same line, they have an opening.
void WalkableArea::join_pieces() {
  const glm::dvec2 along = cover_direction(), across(-along.y, along.x);
  struct End {
    double level, from, to;
    std::uint32_t piece;
    bool is_top;
  };
  std::vector<End> ends;
  for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
    const std::array<glm::dvec2, 4>& corners = pieces_[piece].corners;
    ends.push_back(
        {glm::dot(across, corners[0]), glm::dot(along, corners[0]), glm::dot(along, corners[1]), piece, false});
    ends.push_back(
        {glm::dot(across, corners[2]), glm::dot(along, corners[3]), glm::dot(along, corners[2]), piece, true});
  }
  std::ranges::sort(ends, {}, &End::level);
  std::vector<std::vector<Opening>> openings(pieces_.size());
  for (std::size_t first = 0; first < ends.size();) {
    std::size_t last = first + 1;
    while (last < ends.size() && ends[last].level - ends[last - 1].level < same_level) ++last;
    const std::span<End> level = std::span(ends).subspan(first, last - first);
    std::ranges::sort(level, {}, &End::from);
    for (std::size_t i = 0; i < level.size(); ++i) {
      for (std::size_t j = i + 1; j < level.size() && level[j].from < level[i].to; ++j) {
        const End &a = level[i], &b = level[j];
        const double from = b.from, to = std::min(a.to, b.to);
        if (a.is_top == b.is_top || a.piece == b.piece || to - from < narrowest_opening) continue;
        const glm::dvec2 begin = from * along + a.level * across, end = to * along + a.level * across;
        openings[a.piece].push_back({begin, end, b.piece});
        openings[b.piece].push_back({begin, end, a.piece});
      }
    }
    first = last;
  }
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    pieces_[piece].first_opening = static_cast<std::uint32_t>(openings_.size());
    pieces_[piece].opening_count = static_cast<std::uint32_t>(openings[piece].size());
    openings_.insert(openings_.end(), openings[piece].begin(), openings[piece].end());
  }
}

// A piece that reaches beyond the grid lies in the squares at the edge too.
void WalkableArea::sort_into_squares() {
  Box box;
  for (const Piece& piece : pieces_) {
    for (const glm::dvec2& corner : piece.corners) {
      const bool is_far = std::max(std::abs(corner.x), std::abs(corner.y)) > 0.5 * floor_margin;
      if (!is_far) box.add(std::span(&corner, 1));
    }
  }
  if (box.low.x > box.high.x) box.low = box.high = glm::dvec2(0.0);
  const glm::dvec2 extent = box.high - box.low;
  const double side = std::max(square, std::sqrt(extent.x * extent.y / most_squares));
  lowest_ = box.low;
  squares_a_metre_ = 1.0 / std::max(side, std::max(extent.x, extent.y) / most_squares);
  columns_ = static_cast<std::size_t>(extent.x * squares_a_metre_) + 1;
  rows_ = static_cast<std::size_t>(extent.y * squares_a_metre_) + 1;
  first_in_square_.assign(columns_ * rows_ + 1, 0);
  const auto visit = [&](const auto& take) {
    for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
      Box around;
      around.add(pieces_[piece].corners);
      for (std::size_t z = row(around.low.y); z <= row(around.high.y); ++z) {
        for (std::size_t x = column(around.low.x); x <= column(around.high.x); ++x) take(z * columns_ + x, piece);
      }
    }
  };
  visit([&](std::size_t place, std::uint32_t) { ++first_in_square_[place]; });
  std::uint32_t end = 0;
  for (std::uint32_t& first : first_in_square_) first = end += first;
  in_squares_.resize(end);
  visit([&](std::size_t place, std::uint32_t piece) { in_squares_[--first_in_square_[place]] = piece; });
}

std::span<const std::uint32_t> WalkableArea::pieces_in(std::size_t square_number) const {
  const std::uint32_t first = first_in_square_[square_number];
  return std::span(in_squares_).subspan(first, first_in_square_[square_number + 1] - first);
}

std::size_t WalkableArea::column(double x) const {
  return static_cast<std::size_t>(
      std::clamp((x - lowest_.x) * squares_a_metre_, 0.0, static_cast<double>(columns_ - 1)));
}

std::size_t WalkableArea::row(double z) const {
  return static_cast<std::size_t>(std::clamp((z - lowest_.y) * squares_a_metre_, 0.0, static_cast<double>(rows_ - 1)));
}

/// Goes from piece to piece within a cell, and adds up their areas in it.
class WalkableArea::Walk {
 public:
  Walk(const WalkableArea& area, const glm::dvec2& person, const ConvexPolygon& cell)
      : area_(area), person_(person), cell_(cell) {}

  float all_from(std::uint32_t piece) {
    float sum = 0.0F;
    seen_[seen_count_++] = piece;
    for (std::size_t next = 0; next < seen_count_; ++next) {
      const Piece& here = area_.pieces_[seen_[next]];
      sum += part_in(here);
      for (std::uint32_t i = 0; i < here.opening_count; ++i) go_through(area_.openings_[here.first_opening + i]);
    }
    return sum;
  }
  /// Returns the square metres of a piece that lie in the cell.
  float part_in(const Piece& piece) const {
    ConvexPolygon part = cell_;
    for (std::size_t i = 0; i < piece.corners.size() && !part.is_empty(); ++i) {
      const glm::vec2 from = about_person(piece.corners.at(i));
      const glm::vec2 way = about_person(piece.corners.at((i + 1) % piece.corners.size())) - from;
      const float length = glm::length(way);
      constexpr float shortest = 1e-6F;
      if (length < shortest) continue;
      const glm::vec2 outwards = glm::vec2(way.y, -way.x) / length;
      part.cut(outwards, glm::dot(outwards, from));
    }
    return part.is_empty() ? 0.0F : part.area();
  }

 private:
  glm::vec2 about_person(const glm::dvec2& place) const { return place - person_; }
  void go_through(const Opening& opening) {
    auto* const end = seen_.begin() + static_cast<std::ptrdiff_t>(seen_count_);
    if (seen_count_ == seen_.size() || std::find(seen_.begin(), end, opening.other) != end) return;
    const float width = length_within(cell_, about_person(opening.from), about_person(opening.to));
    if (width >= static_cast<float>(narrowest_opening)) seen_[seen_count_++] = opening.other;
  }

  const WalkableArea& area_;
  glm::dvec2 person_;
  const ConvexPolygon& cell_;
  std::array<std::uint32_t, 256> seen_;
  std::size_t seen_count_ = 0;
};

std::uint32_t WalkableArea::piece_of(glm::dvec2 person, const ConvexPolygon& cell) const {
  for (const std::uint32_t piece : pieces_in(row(person.y) * columns_ + column(person.x))) {
    if (holds(pieces_[piece].corners, person)) return piece;
  }
  const double reach = std::sqrt(static_cast<double>(cell.reach_squared()));
  std::uint32_t nearest = no_piece;
  double least = reach;
  for (std::size_t z = row(person.y - reach); z <= row(person.y + reach); ++z) {
    for (std::size_t x = column(person.x - reach); x <= column(person.x + reach); ++x) {
      for (const std::uint32_t piece : pieces_in(z * columns_ + x)) {
        const double distance = distance_to(pieces_[piece].corners, person);
        if (distance >= least || Walk(*this, person, cell).part_in(pieces_[piece]) <= 0.0F) continue;
        nearest = piece;
        least = distance;
      }
    }
  }
  return nearest;
}

float WalkableArea::area_around(glm::vec2 person, const ConvexPolygon& cell) const {
  if (is_everywhere()) return cell.area();
  const std::uint32_t piece = piece_of(person, cell);
  return piece == no_piece ? 0.0F : Walk(*this, person, cell).all_from(piece);
}

}  // namespace throng::app
