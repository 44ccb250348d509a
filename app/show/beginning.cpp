#include "app/show/beginning.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/exit_status.h"
#include "app/show/camera/fly_camera.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

// At a window the person is selected too, so that its card is there, and Esc ends it.
bool follow_from_start(const std::string& name, ShowParts& show, const DemoOptions& options, StartError& error) {
  const auto follow = follow_camera(*show.stage, name);
  if (!follow) return fail(error, exit_usage, "--camera " + options.camera_name + ": " + follow.error().message);
  const bool selects = options.context == ContextKind::window && follow->agent() && !options.selected;
  if (selects) show.stage->select(follow->agent());
  show.view.guide.follow_behind(*follow, selects);
  show.view.camera = show.view.guide.moved(*show.stage, show.view.camera, false);
  return true;
}

}  // namespace

Result<TrackClock> first_clock(const Trajectories& tracks, const TrajectoryOptions& asked, bool repeats_unasked) {
  TrackClock clock{.seconds = tracks.first_seconds, .first = tracks.first_seconds, .last = tracks.last_seconds};
  const auto has = [clock](double seconds) { return seconds >= clock.first && seconds <= clock.last; };
  const auto refusal = [&](const std::string& option) {
    return Error{option + ": " + tracks.file + " has rows from " + std::to_string(clock.first) + " to " +
                 std::to_string(clock.last) + " s of its clock"};
  };
  if (asked.part && !(has(asked.part->first) && has(asked.part->second))) return refusal("--track-part");
  if (asked.start && !has(*asked.start)) return refusal("--start");
  clock.repeats = asked.repeats.value_or(repeats_unasked);
  clock.rate = asked.rate.value_or(1.0);
  if (asked.part) clock = with_part(clock, asked.part->first, asked.part->second);
  if (asked.start && (*asked.start < clock.first || *asked.start > clock.last)) {
    return Error{"--start: lies outside of the part that --track-part names"};
  }
  clock.seconds = asked.start.value_or(clock.rate < 0.0 ? clock.last : clock.first);
  return clock;
}

bool begin_tracks(Stage& stage, const DemoOptions& options, StartError& error) {
  const Trajectories* const tracks = stage.trajectories().get();
  if (tracks == nullptr || tracks->is_live) return true;
  const auto clock = first_clock(*tracks, options.trajectories, options.context == ContextKind::window);
  if (!clock) return fail(error, exit_usage, clock.error().message);
  stage.set_track_clock(*clock);
  return true;
}

bool place_camera(ShowParts& show, const DemoOptions& options, StartError& error) {
  constexpr std::string_view follows = "follow:";
  ShowView& view = show.view;
  const bool follows_person = options.camera_name.starts_with(follows);
  const auto cameras = cameras_of(*show.stage, view.aspect(), view.free);
  const NamedCamera* named = find_camera(cameras, follows_person ? "" : options.camera_name);
  if (named == nullptr) {
    std::vector<std::string> names;
    names.reserve(cameras.size());
    for (const NamedCamera& each : cameras) names.emplace_back(each.name);
    return fail(error, exit_usage,
                "--camera " + options.camera_name + ": this scene has no such camera; it has " + joined(names));
  }
  view.guide = CameraGuide();
  view.camera = camera_at(options.camera.value_or(named->place));
  view.guide.take_path(options.camera_path, view.camera);
  if (!options.camera_path_file.empty()) {
    auto keys = read_camera_keys(options.camera_path_file);
    if (!keys) return fail(error, exit_job_failed, keys.error().message);
    view.camera = along(*keys, 0.0);
    view.guide.take_path(CameraPath::none, view.camera);
    view.guide.take_keys(std::move(*keys), options.camera_path_file);
  }
  if (show.live != nullptr && !options.camera) view.guide.frame_live(std::string(named->name));
  view.films = options.camera_path != CameraPath::none || !options.camera_path_file.empty() ||
               (!options.camera && (options.camera_name.empty() || show.live != nullptr));
  return !follows_person || follow_from_start(options.camera_name.substr(follows.size()), show, options, error);
}

}  // namespace throng::app
