#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/settings/settings.h"
#include "app/stage/stage.h"
#include "app/view/scenes.h"
#include "engine/render/camera.h"

namespace throng::app {

/// Returns the named cameras of the scene on a stage.
/// `aspect` is that of the picture.
std::vector<NamedCamera> cameras_of(const Stage& stage, float aspect = 16.0F / 9.0F);

/// Moves the camera where nobody flies it: along a path, as the film of a cut scene, or with an agent.
class CameraGuide {
 public:
  /// Takes a path that begins at `start`.
  void take_path(CameraPath path, const render::Camera& start) { path_ = path, start_ = start; }

  /// Returns where the camera begins in the scene on the stage, which may be another one than before. A path begins
  /// there too.
  render::Camera begin_scene(const Stage& stage);
  /// Returns where the camera goes back to: the beginning of its path, or the scene's first camera.
  render::Camera home(const Stage& stage) const;

  /// Returns whether there is a path or a film.
  bool can_film(const Stage& stage) const;

  /// Lets the camera go with the selected agent, from where it is, until nobody is selected.
  void follow(bool follow) { follows_ = follow; }
  bool follows() const { return follows_; }

  /// Returns the camera in the moment on the stage. `films`: a path or a film has it. Call it once a frame.
  render::Camera moved(const Stage& stage, const render::Camera& camera, bool films);

 private:
  /// An agent and where it was in the frame before.
  struct Followed {
    std::uint32_t agent = 0;
    glm::vec3 place{0.0F};
  };
  render::Camera carried(const Stage& stage, const render::Camera& camera);

  CameraPath path_ = CameraPath::none;
  render::Camera start_;
  bool follows_ = false;
  std::optional<Followed> followed_;
};

}  // namespace throng::app
