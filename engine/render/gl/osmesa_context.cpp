#include <array>
#include <cstdint>
#include <memory>
#include <utility>

#include <glad/gl.h>

#include "throng/render/context.h"

#include "engine/render/gl/shared_library.h"

namespace throng::render::gl {
namespace {

constexpr const char* library_name = "libOSMesa.so.8";

// OSMesa's interface, as Mesa's GL/osmesa.h has it. Mesa dropped the header in 25.1, and no header is needed to open
// the library at run time.
constexpr int attribute_format = 0x22, format_rgba = GL_RGBA;
constexpr int attribute_depth_bits = 0x30;
constexpr int attribute_profile = 0x33, core_profile = 0x34;
constexpr int attribute_major_version = 0x36, attribute_minor_version = 0x37;
struct OsMesaHandle;
using Procedure = void (*)();

/// Finds the functions of OSMesa by name.
struct OsMesa {
  SharedLibrary library;
  OsMesaHandle* (*create_context)(const int* attributes, OsMesaHandle* shared) = nullptr;
  GLboolean (*make_current)(OsMesaHandle* context, void* pixels, GLenum type, GLsizei width, GLsizei height) = nullptr;
  void (*destroy_context)(OsMesaHandle* context) = nullptr;
  Procedure (*get_procedure)(const char* name) = nullptr;

  bool find_functions() {
    find_function(library, create_context, "OSMesaCreateContextAttribs");
    find_function(library, make_current, "OSMesaMakeCurrent");
    find_function(library, destroy_context, "OSMesaDestroyContext");
    find_function(library, get_procedure, "OSMesaGetProcAddress");
    return create_context != nullptr && make_current != nullptr && destroy_context != nullptr &&
           get_procedure != nullptr;
  }
};

class OsMesaContext final : public Context {
 public:
  ~OsMesaContext() override {
    if (context_ != nullptr) functions_.destroy_context(context_);
  }

  Status open() {
    Result<SharedLibrary> library = open_library(library_name, "libosmesa6");
    if (!library) return library.error();
    functions_.library = std::move(*library);
    if (!functions_.find_functions())
      return Error{"libOSMesa.so.8 lacks functions of OSMesa, install libosmesa6 again"};
    constexpr int attributes[][2] = {{attribute_format, format_rgba}, {attribute_profile, core_profile},
                                     {attribute_major_version, 4},    {attribute_minor_version, 5},
                                     {attribute_depth_bits, 0},       {}};
    context_ = functions_.create_context(attributes[0], nullptr);
    if (context_ == nullptr ||
        functions_.make_current(context_, unseen_pixels_.data(), GL_UNSIGNED_BYTE, unseen_size, unseen_size) == 0) {
      return Error{"OSMesa gives no OpenGL 4.5 core context"};
    }
    return load_functions(functions_.get_procedure);
  }

  const char* kind() const override { return "osmesa"; }

 private:
  // OSMesa becomes current only with pixels to draw into, but everything is drawn into our own framebuffers.
  static constexpr int unseen_size = 16;
  OsMesa functions_;
  OsMesaHandle* context_ = nullptr;
  std::array<std::uint8_t, 4UL * unseen_size * unseen_size> unseen_pixels_{};
};

}  // namespace

bool osmesa_is_installed() {
  static const bool is_there = is_installed(library_name);
  return is_there;
}

Result<std::unique_ptr<Context>> make_osmesa_context() { return open_context<OsMesaContext>(); }

}  // namespace throng::render::gl
