// The options of a recorded crowd.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options_commands.h"
#include "app/settings/track_values.h"
#include "engine/tracks/live/live_crowd.h"

namespace throng::app {
namespace {

std::string name_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

Complaint take_up_axis(TrackReading& reading, anim::UpAxis axis) {
  if (axis == anim::UpAxis::y) return reading.up = TrackUp::y, Complaint();
  if (axis == anim::UpAxis::z) return reading.up = TrackUp::z, Complaint();
  return "--up: of trajectories it is y or z";
}

void declare(OptionReader& reader, const TrackValue& value, TrajectoryOptions& tracks) {
  const std::string name = value.option_name(), help(value.help);
  if (!value.is_flag()) return static_cast<void>(reader.value(name, value.hint(), help, value.reader(tracks)));
  reader.optional_value(name, "on", value.hint(), help, value.reader(tracks));
}

void declare_all(OptionReader& reader, TrackValue::Kind kind, TrajectoryOptions& tracks) {
  for (const TrackValue& value : track_values()) {
    if (value.kind == kind && !value.option.empty()) declare(reader, value, tracks);
  }
}

/// Returns the first option of such values that the line names; empty if it names none.
std::string given_of(const OptionReader& reader, TrackValue::Kind kind) {
  for (const TrackValue& value : track_values()) {
    if (value.kind == kind && !value.option.empty() && reader.given(value.option_name())) return value.option_name();
  }
  return {};
}

/// A recorded crowd has as many people as it has, and no recording holds it.
std::optional<std::string> contradiction_of_tracks(const OptionReader& reader, bool is_named_here, bool is_live) {
  for (const char* const option : {"--scene", "--agents", "--replay", "--record"}) {
    if (is_live && option == std::string_view("--agents")) continue;
    if (!is_named_here && option == std::string_view("--scene")) continue;
    if (reader.given(option)) return std::string(option) + ": does not go with --trajectories";
  }
  const std::string played = is_live ? given_of(reader, TrackValue::Kind::playing) : std::string();
  if (played.empty()) return {};
  return played + ": rows of standard input are shown as they come; leave it out";
}

}  // namespace

void declare_track_reading(OptionReader& reader, TrajectoryOptions& tracks) {
  declare_all(reader, TrackValue::Kind::reading, tracks);
}

void declare_track_part(OptionReader& reader, const char* help, TrajectoryOptions& tracks) {
  const TrackValue& part = *std::ranges::find(track_values(), "part", &TrackValue::key);
  reader.value(part.option_name(), part.hint(), help, part.reader(tracks));
}

void declare_trajectories(OptionReader& reader, DemoOptions& options) {
  reader.option_defaults()->group("Trajectories: a recorded or simulated crowd");
  for (const auto kind : {TrackValue::Kind::file, TrackValue::Kind::reading, TrackValue::Kind::playing}) {
    declare_all(reader, kind, options.trajectories);
  }
}

std::optional<std::string> settle_trajectories(const OptionReader& reader, DemoOptions& options) {
  TrajectoryOptions& asked = options.trajectories;
  if (asked.file.empty()) {
    for (const auto kind : {TrackValue::Kind::reading, TrackValue::Kind::playing}) {
      if (const std::string option = given_of(reader, kind); !option.empty())
        return option + ": goes with --trajectories";
    }
    return {};
  }
  const bool is_named_here = reader.given("--trajectories"), is_live = asked.file == "-";
  if (is_named_here) options.tuning.scene = Scene::tracks;
  if (options.tuning.scene == Scene::tracks) {
    if (auto contradiction = contradiction_of_tracks(reader, is_named_here, is_live)) return contradiction;
    options.values_given.keys.emplace_back("agents");
  }
  if (is_live && is_named_here && !reader.given("--agents")) options.tuning.agents = LiveCrowd::usual_places;
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
