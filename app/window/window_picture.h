#pragma once

#include <chrono>

#include "engine/base/result.h"

namespace throng::app {

class Messages;
class Overlay;
class Show;

/// The picture in a window: its size, the part of it that is drawn, and its shaders. What fails is told to the person,
/// and the picture before stays.
class WindowPicture {
 public:
  using Clock = std::chrono::steady_clock;

  WindowPicture(Show& show, Messages& messages) : show_(show), messages_(messages) {}

  /// Makes the device ready to draw the panel. Errors: those of render::Renderer::prepare_overlay.
  Status prepare(Overlay& overlay);
  /// Takes the size of the window. A minimised window has no pixels: the crowd goes on, unseen.
  void fit_to_window();
  /// Draws the show with the panel over it. Errors: the first picture cannot be drawn. Later a person can take the
  /// value back that is too much to draw.
  Status present(Overlay& overlay);
  /// Builds the shaders that were saved since the last look, twice a second.
  void build_saved_shaders(Clock::time_point now);

 private:
  Show& show_;
  Messages& messages_;
  Clock::time_point next_look_at_shaders_ = Clock::now();
  bool minimised_ = false;
};

}  // namespace throng::app
