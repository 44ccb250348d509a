#include "app/people/measure/line_counts.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace throng::app {
namespace {

/// A row as the line sees it, in the axes of the file.
struct SeenRow {
  glm::dvec2 place;
  double seconds = 0.0;
  double beside = 0.0;  ///< 0 on the line or its extension, above 0 to the left
};

/// Returns the share of the way from one row to the next at which a person stands on the line or its extension.
double share_at_line(const SeenRow& from, const SeenRow& to) { return from.beside / (from.beside - to.beside); }

bool is_jump(const SeenRow& from, const SeenRow& to) {
  return glm::distance(from.place, to.place) > static_cast<double>(fastest_person) * (to.seconds - from.seconds);
}

}  // namespace

LineCounts count_passages(const Trajectories& tracks, const glm::dvec2& begin, const glm::dvec2& end, double first,
                          double last) {
  const glm::dvec2 along = end - begin;
  const auto seen = [&](const TrackRow& row) {
    // z points against the file's y.
    const glm::dvec2 place = tracks.origin + glm::dvec2(row.x, -row.z), way = place - begin;
    return SeenRow{.place = place, .seconds = row.seconds, .beside = along.x * way.y - along.y * way.x};
  };
  LineCounts counts{.seconds = last - first};
  for (const PersonTrack& person : tracks.persons) {
    for (std::size_t next = 1; next < person.rows.size(); ++next) {
      const SeenRow from = seen(person.rows[next - 1]), to = seen(person.rows[next]);
      const bool goes_left = to.beside > 0.0;  // a person on the line is still to the right of it
      if ((from.beside > 0.0) == goes_left || is_jump(from, to)) continue;
      const double share = share_at_line(from, to), seconds = std::lerp(from.seconds, to.seconds, share);
      const glm::dvec2 way = from.place + share * (to.place - from.place) - begin;
      const double reached = glm::dot(way, along) / glm::dot(along, along);
      if (reached < 0.0 || reached > 1.0 || seconds < first || seconds > last) continue;
      ++(goes_left ? counts.to_left : counts.to_right);
    }
  }
  return counts;
}

}  // namespace throng::app
