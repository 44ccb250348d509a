#pragma once

#include <optional>

#include "throng/render/camera.h"

#include "app/show/camera_guide.h"
#include "app/show/recording/recording.h"

namespace throng::app {

/// Says from where a picture is drawn, and from where level of detail looks in it.
struct PaintedView {
  render::Camera camera;
  std::optional<render::Camera> frozen;  ///< from where level of detail looks while a person holds it there
  int width = 0, height = 0;

  const render::Camera& lod_camera() const { return frozen ? *frozen : camera; }
  LodView for_level_of_detail() const { return {lod_camera(), width, height}; }
  float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

/// The camera of a show with its picture. A person sets the camera, or the guide moves it from frame to frame.
struct ShowView : PaintedView {
  bool films = false;  ///< a camera path or the camera of a cut scene sets `camera` in each frame, where there is one
  CameraGuide guide;
  PicturePart free = {};  ///< the part of the picture that no panel hides

  /// Takes the camera that the scene on the stage brings.
  void begin_scene(const Stage& stage) { camera = guide.begin_scene(stage, aspect(), free), films = true; }
  /// Moves the camera for the moment on the stage, and freezes it for level of detail if `freezes`. Call it once a
  /// frame.
  void move(const Stage& stage, bool freezes) {
    camera = guide.moved(stage, camera, films, aspect(), free);
    if (!freezes) frozen.reset();
    if (freezes && !frozen) frozen = camera;
  }
};

}  // namespace throng::app
