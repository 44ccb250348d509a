// The options of a recorded crowd.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options_commands.h"
#include "engine/tracks/live/live_crowd.h"

namespace throng::app {
namespace {

constexpr double most_rows_a_second = 10'000.0;
constexpr double farthest_time = 1e12;  // seconds
constexpr double fastest_rate = 100.0;
constexpr std::array needs_file{"--walls",   "--fps",   "--time-unit",  "--unit",       "--height",      "--angle",
                                "--lenient", "--start", "--track-rate", "--track-part", "--track-repeat"};

std::string name_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

ValueReader track_rate(std::optional<double>& target) {
  return [&target](const std::string& text) -> Complaint {
    double rate = 0.0;
    const Complaint complaint = read_number(text, -fastest_rate, fastest_rate, rate);
    if (complaint || rate == 0.0) return "must be a number, -100 to 100, and not 0";
    target = rate;
    return {};
  };
}

ValueReader track_part(std::optional<std::pair<double, double>>& target) {
  return [&target](const std::string& text) -> Complaint {
    const std::size_t comma = text.find(',');
    std::pair<double, double> part;
    const bool is_part = comma != std::string::npos &&
                         !read_number(text.substr(0, comma), -farthest_time, farthest_time, part.first) &&
                         !read_number(text.substr(comma + 1), -farthest_time, farthest_time, part.second);
    if (!is_part) return "must be two numbers of seconds, 12.5,40";
    target = part;
    return {};
  };
}

/// Reads a word for a unit, or the metres of one.
ValueReader length_unit(std::optional<double>& target) {
  return [&target](const std::string& text) -> Complaint {
    std::optional<double> number;
    if (!choice<double>(number, {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"km", 1000.0}, {"ft", 0.3048}})(text) ||
        !real_number(number, 1e-6, 1e6)(text)) {
      target = number;
      return {};
    }
    return "must be m, cm, mm, km, ft or the metres of a unit, 0.000001 to 1000000";
  };
}

Complaint take_up_axis(TrackReading& reading, anim::UpAxis axis) {
  if (axis == anim::UpAxis::y) return reading.up = TrackUp::y, Complaint();
  if (axis == anim::UpAxis::z) return reading.up = TrackUp::z, Complaint();
  return "--up: of trajectories it is y or z";
}

}  // namespace

void declare_track_reading(OptionReader& reader, TrackReading& reading) {
  reader.value("--walls", "FILE", "Walls and floors: WKT, .scenario or .floor (what the file has)",
               file_name(reading.walls));
  reader.value("--fps", "N[/N]", "Frames a second of its rows, where they have frames (what the file says)",
               frame_rate(reading.fps, 0.001, most_rows_a_second));
  reader.value(
      "--time-unit", "s|ms|us|ns|min", "The unit of its times, where rows have times (by name of the column)",
      choice<double>(reading.times_a_second, {{"s", 1.0}, {"ms", 1e3}, {"us", 1e6}, {"ns", 1e9}, {"min", 1.0 / 60.0}}));
  reader.value("--unit", "m|cm|mm|km|ft|X", "The unit of its places, or how many metres it is (told apart)",
               length_unit(reading.metres_a_unit));
  reader.value(
      "--height", "head|ground|none", "What its third coordinate is the height of; none: leave it out (by format)",
      choice<TrackHeight>(reading.height,
                          {{"head", TrackHeight::head}, {"ground", TrackHeight::ground}, {"none", TrackHeight::none}}));
  reader.value("--angle", "degrees|radians|north|none",
               "What its angles are: from +x, or degrees clockwise from north; none: leave them out (told apart)",
               choice<TrackAngle>(reading.angle, {{"degrees", TrackAngle::degrees},
                                                  {"radians", TrackAngle::radians},
                                                  {"north", TrackAngle::north},
                                                  {"none", TrackAngle::none}}));
  reader.flag("--lenient", reading.lenient, "Skip rows that are wrong, and count them");
}

void declare_track_part(OptionReader& reader, const char* help, std::optional<std::pair<double, double>>& part) {
  reader.value("--track-part", "T,T", help, track_part(part));
}

void declare_trajectories(OptionReader& reader, DemoOptions& options) {
  reader.option_defaults()->group("Trajectories: a recorded or simulated crowd");
  reader.value(
      "--trajectories", "FILE|-",
      "People, places and times: JuPedSim, Vadere, Jülich text, SUMO, Pathfinder, obsmat, ndjson or any CSV; -: rows "
      "of standard input as they come, for at most --agents people at once (1000)",
      any_text(options.trajectories.file));
  declare_track_reading(reader, options.trajectories.reading);
  reader.value("--start", "T", "Seconds of its clock at which the crowd begins (its first row)",
               real_number(options.trajectories.start, -farthest_time, farthest_time));
  reader.value("--track-rate", "X", "Seconds of its clock a second, -100 to 100; below 0: backwards (1)",
               track_rate(options.trajectories.rate));
  declare_track_part(reader, "Play from one to the other second of its clock only (all of it)",
                     options.trajectories.part);
  reader.flag("--track-repeat", options.trajectories.repeats,
              "Begin anew at the end of the part (a window does; without one: stay there)");
}

std::optional<std::string> settle_trajectories(const OptionReader& reader, DemoOptions& options) {
  TrajectoryOptions& asked = options.trajectories;
  if (asked.file.empty()) {
    for (const char* const option : needs_file) {
      if (reader.given(option)) return std::string(option) + ": goes with --trajectories";
    }
    return {};
  }
  const bool is_live = asked.file == "-";
  for (const char* const option : {"--scene", "--agents", "--replay", "--record"}) {
    if (is_live && option == std::string_view("--agents")) continue;
    if (reader.given(option)) return std::string(option) + ": does not go with --trajectories";
  }
  for (const char* const option : {"--start", "--track-rate", "--track-part", "--track-repeat"}) {
    if (!is_live || !reader.given(option)) continue;
    return std::string(option) + ": rows of standard input are shown as they come; leave it out";
  }
  if (is_live && !reader.given("--agents")) options.tuning.agents = LiveCrowd::usual_places;
  options.tuning.scene = Scene::tracks;
  options.values_given.keys.emplace_back("agents");
  const auto named = std::ranges::find(options.placements, name_of(asked.file), &ModelPlacement::model);
  std::optional<anim::UpAxis> axis;
  if (named != options.placements.end()) {
    axis = named->up;
    options.placements.erase(named);
  } else if (options.models.empty() && options.cast.empty() && reader.given("--up")) {
    axis = std::exchange(options.placement.up, anim::UpAxis::y);
  }
  return axis ? take_up_axis(asked.reading, *axis) : Complaint();
}

}  // namespace throng::app
