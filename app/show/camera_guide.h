#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "throng/render/camera.h"

#include "app/settings/settings.h"
#include "app/show/camera/camera_path.h"
#include "app/show/camera/scenes.h"
#include "app/show/crowd_framing.h"
#include "app/show/follow_camera.h"
#include "engine/tracks/ground_bounds.h"

namespace throng::app {

class Stage;

/// Returns the named cameras of the scene on a stage.
/// `aspect` is the aspect ratio of the picture; those of a recorded crowd see all of it in `part` of the picture.
std::vector<NamedCamera> cameras_of(const Stage& stage, float aspect = usual_aspect, const PicturePart& part = {});

/// Moves the camera while no person flies it: along a path, as the film of a cut scene, with an agent, or back from a
/// live crowd that grows.
class CameraGuide {
 public:
  /// Takes a path that begins at `start`.
  void take_path(CameraPath path, const render::Camera& start) { path_ = path, start_ = start; }

  /// Takes a path of keys in its place, from a file.
  void take_keys(std::vector<CameraKey> keys, std::string file) { keys_ = std::move(keys), file_ = std::move(file); }

  /// Returns the path as `--camera-path` takes it; empty: there is none.
  std::string path_text() const;
  /// Returns what else `--camera` takes than a place: the name of a live crowd's camera, or follow:ID; empty: nothing.
  std::string camera_text(const Stage& stage, bool films) const;

  /// Returns where the camera begins in the scene on the stage, which may be another one than before. A path begins
  /// there too.
  render::Camera begin_scene(const Stage& stage, float aspect = usual_aspect, const PicturePart& part = {});
  /// Returns where the camera goes back to: the beginning of its path, or the scene's first camera.
  render::Camera home(const Stage& stage, float aspect = usual_aspect, const PicturePart& part = {}) const;

  /// Lets a camera of a live crowd hold all that it has seen of it, whenever it films.
  void frame_live(const std::string& name) { live_name_ = name; }

  /// Returns whether there is a path, a film or a live crowd.
  bool can_film(const Stage& stage) const;

  /// Lets the camera go with the selected agent, from where it is, until no agent is selected.
  void follow(bool follow) { follows_ = follow, behind_.reset(); }
  /// Lets the camera go behind an agent from now on.
  /// `while_selected`: it follows the selected agent, until no agent is selected.
  void follow_behind(const FollowCamera& camera, bool while_selected) {
    follows_ = false, behind_ = camera, while_selected_ = while_selected;
  }
  bool follows() const { return follows_ || behind_.has_value(); }

  /// Returns the camera for the moment on the stage. `films`: a path or a film moves it. Call it once a frame.
  render::Camera moved(const Stage& stage, const render::Camera& camera, bool films, float aspect = usual_aspect,
                       const PicturePart& part = {});

 private:
  /// An agent and where it was in the frame before.
  struct Followed {
    std::uint32_t agent = 0;
    glm::vec3 place{0.0F};
  };
  void look_for_another(const Stage& stage);
  render::Camera held_live(const Stage& stage, const render::Camera& camera, float aspect, const PicturePart& part);
  render::Camera carried(const Stage& stage, const render::Camera& camera);

  bool has_path() const { return path_ != CameraPath::none || !keys_.empty(); }

  CameraPath path_ = CameraPath::none;
  std::vector<CameraKey> keys_;  // empty: path_ gives the way
  std::string file_;             // of the keys
  render::Camera start_;
  bool follows_ = false;
  std::optional<Followed> followed_;
  std::optional<FollowCamera> behind_;
  bool while_selected_ = false;
  std::string live_name_;     // empty: no crowd was live
  GroundBounds live_bounds_;  // the bounds that live_place_ frames
  render::Camera live_place_;
  Ticks clock_{};
};

}  // namespace throng::app
