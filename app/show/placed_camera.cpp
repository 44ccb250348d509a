// These members of Show place its camera at the start.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/exit_status.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/show.h"
#include "engine/base/text/joined.h"

namespace throng::app {

bool Show::place_camera(const DemoOptions& options, StartError& error) {
  constexpr std::string_view follows = "follow:";
  const bool is_of_somebody = options.camera_name.starts_with(follows);
  const auto cameras = cameras_of(*stage_, static_cast<float>(width) / static_cast<float>(height));
  const NamedCamera* named = find_camera(cameras, is_of_somebody ? "" : options.camera_name);
  if (named == nullptr) {
    std::vector<std::string> names;
    names.reserve(cameras.size());
    for (const NamedCamera& each : cameras) names.emplace_back(each.name);
    return fail(error, exit_usage,
                "--camera " + options.camera_name + ": this scene has no such camera; it has " + joined(names));
  }
  camera = camera_at(options.camera.value_or(named->place));
  guide.take_path(options.camera_path, camera);
  if (!options.camera_path_file.empty()) {
    auto keys = read_camera_keys(options.camera_path_file);
    if (!keys) return fail(error, exit_job_failed, keys.error().message);
    camera = along(*keys, 0.0);
    guide.take_path(CameraPath::none, camera);
    guide.take_keys(std::move(*keys));
  }
  if (live_ != nullptr && !options.camera) guide.frame_live(std::string(named->name));
  films = options.camera_path != CameraPath::none || !options.camera_path_file.empty() ||
          (!options.camera && (options.camera_name.empty() || live_ != nullptr));
  return !is_of_somebody || follow_from_start(options.camera_name.substr(follows.size()), options, error);
}

// At a window the person is selected too, so that its card is there, and Esc ends it.
bool Show::follow_from_start(const std::string& name, const DemoOptions& options, StartError& error) {
  const auto follow = follow_camera(*stage_, name);
  if (!follow) return fail(error, exit_usage, "--camera " + options.camera_name + ": " + follow.error().message);
  const bool selects = options.context == ContextKind::window && follow->agent() && !options.selected;
  if (selects) stage_->select(follow->agent());
  guide.follow_behind(*follow, selects);
  camera = guide.moved(*stage_, camera, false);
  return true;
}

}  // namespace throng::app
