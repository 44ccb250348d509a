#pragma once

#include <memory>
#include <string>

#include <glm/vec2.hpp>

#include "engine/render/gl/message_log.h"
#include "engine/render/result.h"

struct GLFWwindow;

namespace throng::render::gl {

/// An OpenGL 4.5 core debug context, current on the thread that made it from then on. One per process: glad's function
/// table is global.
class Context {
 public:
  Context() = default;
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// "window", "egl" or "osmesa".
  virtual const char* kind() const = 0;

  /// The window to take input from; null where there is none.
  virtual GLFWwindow* window() const { return nullptr; }

  /// Pixels of the window's own framebuffer; zero where there is no window.
  virtual glm::ivec2 framebuffer_size() const { return {0, 0}; }

  /// Shows what was drawn into the window; nothing to do where there is none.
  virtual void swap_buffers() {}

  const std::string& version() const { return version_; }
  const std::string& renderer() const { return renderer_; }

  /// Drawing runs on the processor, so the same cores that animate also draw.
  bool is_software() const { return software_; }

  MessageLog& messages() { return messages_; }

 protected:
  using Procedure = void (*)();
  using ProcedureSource = Procedure (*)(const char* name);

  /// Loads the function table of the context that is current and starts collecting its messages.
  Status load_functions(ProcedureSource source);

 private:
  std::string version_;
  std::string renderer_;
  bool software_ = false;
  MessageLog messages_;
};

struct WindowOptions {
  int width = 1280;
  int height = 720;
  std::string title = "Throng";
  bool vertical_sync = true;
};

/// A window. Fails, naming --headless, where there is no display.
Result<std::unique_ptr<Context>> make_window_context(const WindowOptions& options);

struct EglOptions {
  bool force_software = false;  ///< for images that must not depend on the graphics card
};

/// No window: the first hardware device that EGL lists, else a surfaceless software one.
Result<std::unique_ptr<Context>> make_egl_context(const EglOptions& options = {});

/// No window and no EGL: Mesa's off-screen library, opened at run time.
Result<std::unique_ptr<Context>> make_osmesa_context();

}  // namespace throng::render::gl
