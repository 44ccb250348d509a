#include <cstdlib>

#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "throng/render/context.h"

namespace throng::render::gl {
namespace {

std::string last_glfw_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description == nullptr ? "unknown reason" : description;
}

/// Leaves out Wayland where no variable tells its socket: libwayland writes an error of its own about it.
void choose_platform() {
#ifdef GLFW_PLATFORM
  const bool tells_socket = std::getenv("XDG_RUNTIME_DIR") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
  if (!tells_socket && glfwPlatformSupported(GLFW_PLATFORM_X11)) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

class WindowContext final : public Context {
 public:
  ~WindowContext() override {
    if (window_ != nullptr) glfwDestroyWindow(window_);
    glfwTerminate();
  }

  Status open(const WindowOptions& options) {
    choose_platform();
    if (glfwInit() == GLFW_FALSE) {
      return Error{"no display to open a window on (" + last_glfw_error() + ")"};
    }
    set_hints();
    window_ = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
      return Error{"no window with OpenGL 4.5 can be opened (" + last_glfw_error() + ")"};
    }
    glfwMakeContextCurrent(window_);
    set_vertical_sync(options.vertical_sync);
    return load_functions(glfwGetProcAddress);
  }

  const char* kind() const override { return "window"; }
  GLFWwindow* window() const override { return window_; }
  void swap_buffers() override { glfwSwapBuffers(window_); }
  void set_vertical_sync(bool on) override { glfwSwapInterval(on ? 1 : 0); }

  glm::ivec2 framebuffer_size() const override {
    glm::ivec2 size{0, 0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
  }

 private:
  static void set_hints() {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    // Our own framebuffer has depth and samples; the window receives finished pixels only.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
  }

  GLFWwindow* window_ = nullptr;
};

}  // namespace

Result<std::unique_ptr<Context>> make_window_context(const WindowOptions& options) {
  return open_context<WindowContext>(options);
}

}  // namespace throng::render::gl
