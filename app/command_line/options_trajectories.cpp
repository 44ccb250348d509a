#include "app/command_line/options_trajectories.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace throng::app {
namespace {

constexpr double most_rows_a_second = 10'000.0;
constexpr double farthest_time = 1e12;  // seconds

std::string name_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

Complaint take_up_axis(TrackReading& reading, anim::UpAxis axis) {
  if (axis == anim::UpAxis::y) return reading.up = TrackUp::y, Complaint();
  if (axis == anim::UpAxis::z) return reading.up = TrackUp::z, Complaint();
  return "--up: of trajectories it is y or z";
}

}  // namespace

void declare_trajectories(OptionReader& reader, DemoOptions& options) {
  TrackReading& reading = options.trajectories.reading;
  reader.option_defaults()->group("Trajectories: a recorded or simulated crowd");
  reader.value("--trajectories", "FILE",
               "Who was where when: JuPedSim, Vadere, Jülich text, SUMO, Pathfinder, obsmat, ndjson or any CSV",
               file_name(options.trajectories.file));
  reader.value("--walls", "FILE", "Walls and floors: WKT, .scenario or .floor (what the file has)",
               file_name(reading.walls));
  reader.value("--fps", "N", "Frames a second of its rows, where they have frames (what the file says)",
               real_number(reading.fps, 0.001, most_rows_a_second));
  reader.value("--unit", "m|cm|mm", "The unit of its places (told apart)",
               choice<double>(reading.metres_a_unit, {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}}));
  reader.value("--height", "head|ground", "What its third coordinate is the height of (by format)",
               choice<TrackHeight>(reading.height, {{"head", TrackHeight::head}, {"ground", TrackHeight::ground}}));
  reader.value("--angle", "degrees|radians", "The unit of its angles (told apart)",
               choice<TrackAngle>(reading.angle, {{"degrees", TrackAngle::degrees}, {"radians", TrackAngle::radians}}));
  reader.value("--start", "T", "Seconds of its clock at which the crowd begins (its first row)",
               real_number(options.trajectories.start, -farthest_time, farthest_time));
  reader.flag("--lenient", reading.lenient, "Skip rows that are wrong, and count them");
}

std::optional<std::string> settle_trajectories(const OptionReader& reader, DemoOptions& options) {
  TrajectoryOptions& asked = options.trajectories;
  if (asked.file.empty()) {
    for (const char* const option : {"--walls", "--fps", "--unit", "--height", "--angle", "--start", "--lenient"}) {
      if (reader.given(option)) return std::string(option) + ": goes with --trajectories";
    }
    return {};
  }
  for (const char* const option : {"--scene", "--agents", "--replay", "--record"}) {
    if (reader.given(option)) return std::string(option) + ": does not go with --trajectories";
  }
  options.tuning.scene = Scene::tracks;
  options.agents_given = true;
  const auto named = std::ranges::find(options.placements, name_of(asked.file), &ModelPlacement::model);
  std::optional<anim::UpAxis> axis;
  if (named != options.placements.end()) {
    axis = named->up;
    options.placements.erase(named);
  } else if (options.models.empty() && options.cast.empty() && reader.given("--up")) {
    axis = std::exchange(options.placement.up, anim::UpAxis::y);
  }
  Complaint complaint = axis ? take_up_axis(asked.reading, *axis) : Complaint();
  return complaint;
}

}  // namespace throng::app
