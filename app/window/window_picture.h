#pragma once

#include <chrono>

#include <glm/vec2.hpp>

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

  WindowPicture(Show& show, Messages& messages);

  /// Makes the device ready to draw the panel. Errors: those of render::Renderer::prepare_overlay.
  Status prepare(Overlay& overlay);
  /// Gives the panel that scale, if it has another.
  void scale(Overlay& overlay, float scale);
  /// Takes the size of the window, and of the picture in it. Of a window out of sight nothing is drawn: the crowd goes
  /// on, unseen.
  void fit_to_window(bool out_of_sight);
  bool is_seen() const { return is_seen_; }
  /// Returns the pixels of the window, in which the panel is drawn and the pointer is.
  glm::ivec2 window_size() const { return size_; }
  /// Draws the show with the panel over it. `is_used` says whether a person uses mouse or keys now: else a processor
  /// draws the panel around the crowd in one of some frames. Errors: the first picture cannot be drawn. Later a person
  /// can take the value back that is too much to draw.
  Status present(Overlay& overlay, bool is_used);
  /// Returns when the work on the last picture was done, without the wait of a card for the screen.
  Clock::time_point drawn_at() const { return drawn_at_; }
  /// Builds the shaders that were saved since the last look, twice a second.
  void build_saved_shaders(Clock::time_point now);

 private:
  bool keeps_panel(bool is_used);

  Show& show_;
  Messages& messages_;
  Clock::time_point next_look_at_shaders_ = Clock::now();
  glm::ivec2 size_;
  Clock::time_point drawn_at_ = Clock::now();
  int frames_with_panel_ = 0;  // that are still to come in a row
  int frames_without_panel_ = 0;
  bool is_seen_ = true;
};

}  // namespace throng::app
