#pragma once

#include "app/show/camera/input.h"

struct GLFWwindow;

namespace throng::app {

/// Listens to a GLFW window through callbacks, so that a key press shorter than a slow frame still counts.
/// It lives on the thread that polls GLFW's events, and no longer than the window. It takes the window's user pointer.
class WindowInput {
 public:
  explicit WindowInput(GLFWwindow* window);
  ~WindowInput();
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;

  /// Waits until something happens at the window, at most so many seconds. next_frame() has it.
  static void wait(double seconds);

  /// Polls the window's events and returns the input of this frame, which is valid until the next call.
  const InputFrame& next_frame();

  /// Returns once whether the window's close button was pressed.
  bool takes_close();

  /// Returns whether the window is minimised or hidden.
  bool is_out_of_sight() const;

  /// Returns how much larger than on a plain screen things are to be on the display that the window is on.
  float content_scale() const;

  /// Returns the text clipboard of the window, which is usable as long as the window lives.
  Clipboard clipboard() const;

  void push(const InputEvent& event) { queue_.push(event); }

 private:
  GLFWwindow* window_;
  InputQueue queue_;
};

}  // namespace throng::app
