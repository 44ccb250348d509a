#pragma once

#include "app/view/input.h"

struct GLFWwindow;

namespace throng::app {

/// Listens to a GLFW window through callbacks of our own, so that a key shorter than a slow frame still counts.
/// Lives on the thread that polls GLFW's events, no longer than the window; takes the window's user pointer.
class WindowInput {
 public:
  explicit WindowInput(GLFWwindow* window);
  ~WindowInput();
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;

  /// Polls the window's events and gives what this frame knows; valid until the next call.
  const InputFrame& next_frame();

  /// The window's close button was pressed.
  bool asked_to_close() const;

  /// The text clipboard of the window; usable as long as the window lives.
  Clipboard clipboard() const;

  void push(const InputEvent& event) { queue_.push(event); }

 private:
  GLFWwindow* window_;
  InputQueue queue_;
};

}  // namespace throng::app
