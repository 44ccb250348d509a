#include "app/people/measure/measure_table.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "throng/host.h"

#include "app/people/crowd/track_steps.h"
#include "app/people/measure/voronoi_density.h"
#include "app/people/measure/walkable_area.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/smooth_track.h"

namespace throng::app {
namespace {

/// A row of a person, with the frame that it belongs to.
struct FrameRow {
  long long frame = 0;
  std::size_t person = 0;
  const TrackRow* row = nullptr;
};

std::vector<FrameRow> rows_by_frame(const Trajectories& tracks, double first, double last) {
  std::vector<FrameRow> rows;
  for (std::size_t person = 0; person < tracks.persons.size(); ++person) {
    for (const TrackRow& row : tracks.persons[person].rows) {
      if (row.seconds < first || row.seconds > last) continue;
      rows.push_back({std::llround(row.seconds * tracks.rows_a_second), person, &row});
    }
  }
  std::ranges::sort(rows, {}, [](const FrameRow& row) { return std::tuple(row.frame, row.person, row.row); });
  return rows;
}

/// Writes the lines of one frame after the other.
class TableWriter {
 public:
  TableWriter(const Trajectories& tracks, float cut_off) : tracks_(tracks), cut_off_(cut_off), area_(tracks.plan) {
    for (const PersonTrack& person : tracks.persons) {
      ways_.push_back(person.rows.empty() ? SmoothTrack() : SmoothTrack(person.rows));
    }
  }

  void add(std::span<const FrameRow> frame) {
    positions_.clear();
    for (const FrameRow& each : frame) positions_.emplace_back(each.row->x, each.row->y, each.row->z);
    densities_.resize(frame.size());
    InOrder here;
    density_.measure({positions_}, cut_off_, area_, here, 1, densities_);
    for (std::size_t i = 0; i < frame.size(); ++i) add_line(frame[i], densities_[i]);
  }

  const std::string& text() const { return text_; }

 private:
  void add_line(const FrameRow& each, float density) {
    const TrackRow& row = *each.row;
    const float speed = glm::length(ways_[each.person].velocity(row.seconds, TrackSteps::stride_window));
    text_ += as_cell(tracks_.persons[each.person].id) + ',' + std::to_string(each.frame) + ',' + fixed(row.seconds, 3);
    text_ += ',' + fixed(tracks_.origin.x + static_cast<double>(row.x), 4);
    text_ += ',' + fixed(tracks_.origin.y - static_cast<double>(row.z), 4);  // z points against the file's y
    text_ += ',' + fixed(speed, 4) + ',' + (density < 0.0F ? "" : fixed(density, 4)) + '\n';
  }

  static std::string as_cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string cell = "\"";
    for (const char letter : text) cell += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return cell + '"';
  }

  const Trajectories& tracks_;
  float cut_off_;
  WalkableArea area_;
  VoronoiDensity density_;
  std::vector<SmoothTrack> ways_;
  std::vector<glm::vec3> positions_;
  std::vector<float> densities_;
  std::string text_ = "id,frame,time,x,y,speed,density\n";
};

}  // namespace

std::string measure_table(const Trajectories& tracks, double first, double last, float cut_off) {
  const std::vector<FrameRow> rows = rows_by_frame(tracks, first, last);
  TableWriter table(tracks, cut_off);
  for (auto begin = rows.begin(); begin != rows.end();) {
    const auto end = std::ranges::upper_bound(begin, rows.end(), begin->frame, {}, &FrameRow::frame);
    table.add(std::span(begin, end));
    begin = end;
  }
  return table.text();
}

}  // namespace throng::app
