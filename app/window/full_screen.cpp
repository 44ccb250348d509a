#include "app/window/full_screen.h"

#include <algorithm>
#include <span>

#include <glm/common.hpp>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace throng::app {
namespace {

/// Returns how many pixels of a window lie on a screen.
int shared_pixels(GLFWmonitor* screen, glm::ivec2 place, glm::ivec2 size) {
  glm::ivec2 corner{0};
  glfwGetMonitorPos(screen, &corner.x, &corner.y);
  const GLFWvidmode* const mode = glfwGetVideoMode(screen);
  if (mode == nullptr) return 0;
  const glm::ivec2 from = glm::max(corner, place),
                   to = glm::min(corner + glm::ivec2(mode->width, mode->height), place + size);
  const glm::ivec2 shared = glm::max(to - from, glm::ivec2(0));
  return shared.x * shared.y;
}

}  // namespace

void FullScreen::toggle() { glfwGetWindowMonitor(window_) != nullptr ? leave() : enter(); }

void FullScreen::leave() {
  glfwSetWindowMonitor(window_, nullptr, place_.x, place_.y, size_.x, size_.y, GLFW_DONT_CARE);
}

void FullScreen::enter() {
  glfwGetWindowPos(window_, &place_.x, &place_.y);
  glfwGetWindowSize(window_, &size_.x, &size_.y);
  int count = 0;
  GLFWmonitor** const all = glfwGetMonitors(&count);
  const std::span screens(all, static_cast<std::size_t>(count));
  const auto shared = [this](GLFWmonitor* screen) { return shared_pixels(screen, place_, size_); };
  const auto screen = std::ranges::max_element(screens, {}, shared);
  const GLFWvidmode* const mode = screen == screens.end() ? nullptr : glfwGetVideoMode(*screen);
  if (mode == nullptr) return;
  glfwSetWindowMonitor(window_, *screen, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace throng::app
