#pragma once

#include <glm/vec2.hpp>

struct GLFWwindow;

namespace throng::app {

/// Lets a window fill the screen that it lies on, and puts it back to its place.
class FullScreen {
 public:
  explicit FullScreen(GLFWwindow* window) : window_(window) {}
  void toggle();

 private:
  void leave();
  void enter();

  GLFWwindow* window_;
  glm::ivec2 place_{0}, size_{0};  // before it filled the screen
};

}  // namespace throng::app
