#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "engine/base/text/plain_text.h"
#include "engine/tracks/file_plan.h"
#include "engine/tracks/text/number_text.h"

namespace throng {
namespace {

constexpr std::size_t most_depth = 16;
constexpr std::size_t most_points = 4'000'000;

/// Reads Well-Known Text, one geometry after the other. A method returns false after the first fault, which error()
/// says.
class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) {}

  bool read_all(FilePlan& plan) {
    for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
      if (text_[at_] == ';' || text_[at_] == ',') {
        ++at_;
      } else if (!read_geometry(plan, 0)) {
        return false;
      }
    }
    return true;
  }
  Error error() const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    return {"line " + std::to_string(line) + ": " + fault_ +
            "; write WKT, such as POLYGON ((0 0, 9 0, 9 5, 0 0)) or LINESTRING (0 0, 9 0)"};
  }

 private:
  bool refuse(std::string fault) {
    fault_ = std::move(fault);
    return false;
  }
  void skip_blanks() {
    for (;; at_ = std::min(text_.find('\n', at_), text_.size())) {
      while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
      if (at_ == text_.size() || text_[at_] != '#') return;  // a comment
    }
  }
  std::string word() {
    skip_blanks();
    std::string word;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
    }
    return word;
  }
  bool takes(char wanted) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }
  bool take(char wanted) {
    if (takes(wanted)) return true;
    if (at_ == text_.size()) return refuse(std::string("it ends where a ") + wanted + " should be");
    return refuse(std::string("a ") + wanted + " should be where \"" + shown_rest() + "\" is");
  }
  std::string shown_rest() const { return plain_text(text_.substr(at_, 12)); }

  /// A bracket, things with commas between them, a bracket; or the word EMPTY.
  template <typename Thing>
  bool read_list(Thing thing) {
    const std::size_t before = at_;
    if (word() == "EMPTY") return true;
    at_ = before;
    if (!take('(')) return false;
    do {
      if (!thing()) return false;
    } while (takes(','));
    return take(')');
  }

  bool read_number_here(double& number) {
    skip_blanks();
    const char* const end = text_.data() + text_.size();
    const char* const stop = read_number(text_.data() + at_, end, number);
    if (stop == nullptr || !std::isfinite(number) || std::abs(number) > 1e10) {
      return refuse(at_ == text_.size() ? "it ends where a number should be"
                                        : "a number should be where \"" + shown_rest() + "\" is");
    }
    at_ = static_cast<std::size_t>(stop - text_.data());
    return true;
  }
  bool read_point(glm::dvec2& point) {
    if (++point_count_ > most_points) return refuse("it has more than 4,000,000 points");
    if (!read_number_here(point.x) || !read_number_here(point.y)) return false;
    double ignored = 0.0;  // z and m
    for (int i = 0; i < 2; ++i) {
      skip_blanks();
      if (at_ < text_.size() && (text_[at_] == ',' || text_[at_] == ')')) break;
      if (!read_number_here(ignored)) return false;
    }
    return true;
  }
  bool read_points(FileRing& points) {
    return read_list([&] { return read_point(points.emplace_back()); });
  }
  bool read_ring(FileRing& ring) {
    if (!read_points(ring)) return false;
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring.empty() || ring.size() > 2 || refuse("a polygon has fewer than three corners");
  }
  bool read_polygon(FilePlan& plan) {
    FileArea area;
    bool is_outline = true;
    const bool is_read = read_list([&] {
      FileRing& ring = is_outline ? area.outline : area.holes.emplace_back();
      is_outline = false;
      return read_ring(ring);
    });
    if (is_read && !area.outline.empty()) plan.floors.push_back(std::move(area));
    return is_read;
  }
  bool read_line(FilePlan& plan) {
    FileLine line;
    if (!read_points(line.points)) return false;
    if (line.points.size() == 1) return refuse("a line has a single point");
    if (!line.points.empty()) plan.walls.push_back(std::move(line));
    return true;
  }
  /// A point of MULTIPOINT may have brackets around it.
  bool read_points_alone() {
    glm::dvec2 ignored{};
    return read_list([&] {
      const bool is_in_brackets = takes('(');
      return read_point(ignored) && (!is_in_brackets || take(')'));
    });
  }
  bool read_geometry(FilePlan& plan, std::size_t depth) {
    if (depth == most_depth) return refuse("collections lie in each other more than 16 deep");
    std::size_t before = at_;
    std::string kind = word();
    if (kind == "SRID") {
      double ignored = 0.0;
      if (!take('=') || !read_number_here(ignored) || !take(';')) return false;
      before = at_;
      kind = word();
    }
    while (kind.ends_with('Z') || kind.ends_with('M')) kind.pop_back();  // LineStringZ
    const std::size_t after = at_;
    if (const std::string dimension = word(); dimension != "Z" && dimension != "M" && dimension != "ZM") at_ = after;
    if (kind == "POINT" || kind == "MULTIPOINT") return read_points_alone();
    if (kind == "LINESTRING" || kind == "LINEARRING") return read_line(plan);
    if (kind == "POLYGON") return read_polygon(plan);
    if (kind == "MULTILINESTRING") return read_list([&] { return read_line(plan); });
    if (kind == "MULTIPOLYGON") return read_list([&] { return read_polygon(plan); });
    if (kind == "GEOMETRYCOLLECTION") return read_list([&] { return read_geometry(plan, depth + 1); });
    at_ = before;
    skip_blanks();
    return refuse(kind.empty() ? "a geometry should be where \"" + shown_rest() + "\" is"
                               : in_quotes(kind.substr(0, 30)) + " is no geometry that is read here");
  }

  std::string_view text_;
  std::size_t at_ = 0, point_count_ = 0;
  std::string fault_;
};

/// Finds the polygons that lie within another one. It may compare each with each, so the work is limited.
class ObstacleSearch {
 public:
  explicit ObstacleSearch(const std::vector<FileArea>& areas) : areas_(areas) {
    for (const FileArea& area : areas) {
      Box box{area.outline.front(), area.outline.front()};
      for (const glm::dvec2& corner : area.outline) box = {glm::min(box.low, corner), glm::max(box.high, corner)};
      boxes_.push_back(box);
    }
  }

  /// Returns whether all corners of an area lie within another one, and not in its holes.
  bool is_obstacle(std::size_t area) {
    for (std::size_t other = 0; other < areas_.size() && !is_too_much(); ++other) {
      ++steps_;
      if (other != area && is_in_box(boxes_[area], boxes_[other]) && is_within(areas_[area].outline, areas_[other])) {
        return true;
      }
    }
    return false;
  }
  bool is_too_much() const { return steps_ > most_steps; }

 private:
  struct Box {
    glm::dvec2 low, high;
  };
  static constexpr std::size_t most_steps = 3'200'000'000;  // some three seconds
  static constexpr std::size_t steps_an_edge = 8;           // a comparison of boxes is one

  static bool is_in_box(const Box& inner, const Box& outer) {
    return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x &&
           inner.high.y <= outer.high.y;
  }
  bool is_inside(const glm::dvec2& point, const FileRing& ring) {
    steps_ += ring.size() * steps_an_edge;
    bool is_in = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const glm::dvec2 &a = ring[i], &b = ring[j];
      if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
        is_in = !is_in;
    }
    return is_in;
  }
  bool is_within(const FileRing& ring, const FileArea& area) {
    return std::ranges::all_of(ring, [&](const glm::dvec2& corner) {
      return !is_too_much() && is_inside(corner, area.outline) &&
             std::ranges::none_of(area.holes, [&](const FileRing& hole) { return is_inside(corner, hole); });
    });
  }

  const std::vector<FileArea>& areas_;
  std::vector<Box> boxes_;
  std::size_t steps_ = 0;
};

/// A polygon within another one is an obstacle.
Status move_obstacles(FilePlan& plan) {
  ObstacleSearch search(plan.floors);
  std::vector<FileArea> floors;
  for (std::size_t i = 0; i < plan.floors.size(); ++i) {
    if (search.is_obstacle(i)) {
      plan.obstacles.push_back(plan.floors[i].outline);
    } else {
      floors.push_back(plan.floors[i]);
    }
    if (search.is_too_much()) {
      return Error{"its " + std::to_string(plan.floors.size()) +
                   " polygons take too long to compare; write obstacles as holes of the floor, or as lines"};
    }
  }
  plan.floors = std::move(floors);
  return Done{};
}

}  // namespace

Result<FilePlan> parse_wkt(std::string_view text) {
  FilePlan plan;
  WktReader reader(text);
  if (!reader.read_all(plan)) return reader.error();
  if (const Status moved = move_obstacles(plan); !moved) return moved.error();
  return plan;
}

}  // namespace throng
