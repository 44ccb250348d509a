#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "throng/result.h"

struct GLFWwindow;

namespace throng::render::gl {

/// The largest sizes that a device takes, as it says itself.
struct DeviceLimits {
  glm::ivec2 target{0};           ///< pixels of a target: textures, renderbuffers and viewports hold it
  int texture = 0;                ///< pixels of a side
  int samples = 0;                ///< a pixel, of colours and of depths
  std::size_t storage_block = 0;  ///< bytes
};

/// Collects the driver's messages in order (KHR_debug, severities above notification). A test fails if there is one.
/// The driver may call from any thread, in the middle of its work: nothing is thrown, and where there is no memory a
/// message is only counted.
class MessageLog {
 public:
  /// The number of messages that are kept; more are only counted.
  static constexpr std::size_t kept_messages = 64;

  void add(std::string_view message) noexcept;
  std::vector<std::string> messages() const;
  std::size_t count() const;
  void clear();

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
  std::size_t count_ = 0;
};

/// An OpenGL 4.5 core debug context. It is current on the thread that made it. A process has one at most, because
/// glad's function table is global.
class Context {
 public:
  Context() = default;
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Gives "window", "egl" or "osmesa".
  virtual const char* kind() const = 0;

  /// Gives the window that input comes from, or null if there is none.
  virtual GLFWwindow* window() const { return nullptr; }

  /// Gives the size of the window's own framebuffer in pixels, or zero if there is no window.
  virtual glm::ivec2 framebuffer_size() const { return {0, 0}; }

  /// Shows what was drawn into the window, if there is one.
  virtual void swap_buffers() {}

  /// Shows the next pictures when the display is refreshed, or at once. A window begins as WindowOptions says. The
  /// context must be current.
  virtual void set_vertical_sync(bool /*on*/) {}

  const std::string& version() const { return version_; }
  const std::string& renderer() const { return renderer_; }

  /// Says whether drawing runs on the processor, on the same cores that animate.
  bool is_software() const { return software_; }

  /// Gives the largest sizes that the device takes.
  const DeviceLimits& limits() const { return limits_; }

  MessageLog& messages() { return messages_; }

 protected:
  using Procedure = void (*)();
  using ProcedureSource = Procedure (*)(const char* name);

  /// Loads the function table of the current context and starts to collect its messages.
  Status load_functions(ProcedureSource source);

 private:
  std::string version_;
  std::string renderer_;
  bool software_ = false;
  DeviceLimits limits_;
  MessageLog messages_;
};

/// Makes a context of a kind that its `open` opens.
template <typename Kind>
Result<std::unique_ptr<Context>> open_context(const auto&... options) {
  auto context = std::make_unique<Kind>();
  if (const Status opened = context->open(options...); !opened) return opened.error();
  return std::unique_ptr<Context>(std::move(context));
}

struct WindowOptions {
  int width = 1280;
  int height = 720;
  std::string title = "Throng";
  bool vertical_sync = true;
};

/// Opens a window. Errors: there is no display, or no OpenGL 4.5 on it. Errors of all contexts say what is wrong with
/// this context; the caller knows which others there are.
Result<std::unique_ptr<Context>> make_window_context(const WindowOptions& options);

struct EglOptions {
  bool force_software = false;  ///< for pictures that must not depend on the graphics card
};

/// Makes a context without a window, on the first hardware device that EGL lists, else on a surfaceless software one.
Result<std::unique_ptr<Context>> make_egl_context(const EglOptions& options = {});

/// Says whether OSMesa is on this machine, which Mesa has no longer since its version 25.1.
bool osmesa_is_installed();

/// Makes a context without a window and without EGL, by Mesa's off-screen library, which it opens at run time. Errors
/// are as for the other contexts, and that the library is not installed.
Result<std::unique_ptr<Context>> make_osmesa_context();

}  // namespace throng::render::gl
