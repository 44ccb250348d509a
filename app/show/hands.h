#pragma once

#include <cstdint>
#include <optional>

#include "app/recording/recorder.h"
#include "app/stage/stage.h"

namespace throng::app {

/// Does to single agents what a person asks for, and records it. It looks at the picture drawn last, and is valid
/// until the show changes.
class Hands {
 public:
  Hands(Stage& stage, Recorder& recorder, const LodView& view) : stage_(stage), recorder_(recorder), view_(view) {}

  /// Selects an agent, or deselects.
  void select(std::optional<std::uint32_t> agent);
  /// Selects the agent that is seen at a pixel from the top left of the picture; deselects where there is none.
  void select_at(float x, float y);
  /// Pushes an agent over. Errors: those of AnimatedCrowd::push_over.
  anim::Status push(std::uint32_t agent, const glm::vec3& direction);
  /// Pushes the selected agent over, away from the camera; does nothing if none is selected.
  anim::Status push_selected();
  /// Does what AnimatedCrowd::hold_clip does.
  void hold_clip(std::uint32_t agent, float seconds);
  /// Does the same with the selected agent; does nothing if none is selected.
  void hold_selected_clip(float seconds);
  void let_go_of_clip();

 private:
  Stage& stage_;
  Recorder& recorder_;
  LodView view_;
};

}  // namespace throng::app
