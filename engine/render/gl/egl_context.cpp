#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#define EGL_NO_PLATFORM_SPECIFIC_TYPES  // else they bring headers of the system, whose macros are common words
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <glad/gl.h>

#include "throng/render/context.h"

#include "engine/base/files/process.h"
#include "engine/render/gl/shared_library.h"

namespace throng::render::gl {
namespace {

/// Finds the functions of EGL by name, so that a machine without EGL still opens windows and OSMesa.
struct Egl {
  SharedLibrary library;
  PFNEGLGETPROCADDRESSPROC get_procedure = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLTERMINATEPROC terminate = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;
  PFNEGLQUERYSTRINGPROC query_string = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;             // null if EGL lists no devices
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;  // null if EGL lists no devices

  bool find_functions() {
    find_function(library, get_procedure, "eglGetProcAddress");
    if (get_procedure == nullptr) return false;
    find_function(library, initialize, "eglInitialize");
    find_function(library, terminate, "eglTerminate");
    find_function(library, bind_api, "eglBindAPI");
    find_function(library, create_context, "eglCreateContext");
    find_function(library, destroy_context, "eglDestroyContext");
    find_function(library, make_current, "eglMakeCurrent");
    find_function(library, query_string, "eglQueryString");
    find_extension(get_platform_display, "eglGetPlatformDisplayEXT");
    find_extension(query_devices, "eglQueryDevicesEXT");
    find_extension(query_device_string, "eglQueryDeviceStringEXT");
    return get_platform_display != nullptr;
  }

 private:
  template <typename Pointer>
  void find_extension(Pointer& function, const char* name) const {
    function = reinterpret_cast<Pointer>(get_procedure(name));
  }
};

bool names(const char* list, std::string_view extension) {
  return list != nullptr && std::string_view(list).find(extension) != std::string_view::npos;
}

constexpr const char* mesa_software = "LIBGL_ALWAYS_SOFTWARE";

/// As Mesa reads it: 0, n, no, f and false do not.
bool asks_for_software(const char* value) {
  constexpr std::string_view none("0nNfF");
  return value != nullptr && *value != '\0' && none.find(*value) == std::string_view::npos;
}

class EglContext final : public Context {
 public:
  ~EglContext() override {
    if (display_ == EGL_NO_DISPLAY) return;
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) egl_.destroy_context(display_, context_);
    if (!keeps_drivers_loaded) egl_.terminate(display_);  // EGL unloads its driver
  }

  Status open(const EglOptions& options) {
    Result<SharedLibrary> library = open_library("libEGL.so.1", "libegl1");
    if (!library) return library.error();
    egl_.library = std::move(*library);
    if (!egl_.find_functions()) return Error{"libEGL.so.1 lacks functions of EGL, install libegl1 again"};
    const bool by_variable = asks_for_software(std::getenv(mesa_software));
    if (by_variable) clear_variable(mesa_software);  // Mesa 26 warns of it where a device is chosen
    const bool opened = std::ranges::any_of(devices(options.force_software || by_variable), [&](EGLDeviceEXT device) {
      return make_current_on(EGL_PLATFORM_DEVICE_EXT, device);
    });
    // Mesa reads this when it loads a driver. The surfaceless platform has no other way to ask for the software driver.
    if (by_variable || (!opened && options.force_software)) set_variable(mesa_software, "1");
    if (opened || make_current_on(EGL_PLATFORM_SURFACELESS_MESA, nullptr)) return load_functions(egl_.get_procedure);
    return Error{"EGL gives no OpenGL 4.5 core context"};
  }

  const char* kind() const override { return "egl"; }

 private:
  /// Tries hardware devices first, or only software ones if forced.
  std::vector<EGLDeviceEXT> devices(bool force_software) const {
    if (egl_.query_devices == nullptr || egl_.query_device_string == nullptr) return {};
    std::array<EGLDeviceEXT, 16> listed{};
    EGLint count = 0;
    if (egl_.query_devices(static_cast<EGLint>(listed.size()), listed.data(), &count) == EGL_FALSE) return {};
    std::vector<EGLDeviceEXT> hardware, software;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const char* extensions = egl_.query_device_string(listed.at(i), EGL_EXTENSIONS);
      (names(extensions, "EGL_MESA_device_software") ? software : hardware).push_back(listed.at(i));
    }
    if (force_software) return software;
    hardware.insert(hardware.end(), software.begin(), software.end());
    return hardware;
  }

  bool make_current_on(EGLenum platform, EGLDeviceEXT device) {
    auto* const display = egl_.get_platform_display(platform, device, nullptr);
    if (display == EGL_NO_DISPLAY || egl_.initialize(display, nullptr, nullptr) == EGL_FALSE) return false;
    context_ = create_context(display);
    if (context_ == EGL_NO_CONTEXT) {
      egl_.terminate(display);
      return false;
    }
    display_ = display;
    return egl_.make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  EGLContext create_context(EGLDisplay display) const {
    const char* extensions = egl_.query_string(display, EGL_EXTENSIONS);
    if (!names(extensions, "EGL_KHR_surfaceless_context") || !names(extensions, "EGL_KHR_no_config_context") ||
        egl_.bind_api(EGL_OPENGL_API) == EGL_FALSE) {
      return EGL_NO_CONTEXT;
    }
    constexpr EGLint attributes[][2] = {{EGL_CONTEXT_MAJOR_VERSION, 4},
                                        {EGL_CONTEXT_MINOR_VERSION, 5},
                                        {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT},
                                        {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE},
                                        {EGL_NONE}};
    return egl_.create_context(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes[0]);
  }

  Egl egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

Result<std::unique_ptr<Context>> make_egl_context(const EglOptions& options) {
  return open_context<EglContext>(options);
}

}  // namespace throng::render::gl
