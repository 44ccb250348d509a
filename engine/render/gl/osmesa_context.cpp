#include "engine/render/gl/context.h"

#if defined(THRONG_HAS_OSMESA)

#include <array>
#include <utility>

#include <glad/gl.h>
// OSMesa's header needs OpenGL's types, which glad declares.
#include <GL/osmesa.h>

#include "engine/render/gl/shared_library.h"

namespace throng::render::gl {
namespace {

/// Finds the functions of OSMesa by name.
struct OsMesa {
  SharedLibrary library;
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaGetProcAddress) get_procedure = nullptr;

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
    Result<SharedLibrary> library = open_library("libOSMesa.so.8", "libosmesa6");
    if (!library) return library.error();
    functions_.library = std::move(*library);
    if (!functions_.find_functions())
      return Error{"libOSMesa.so.8 lacks functions of OSMesa, install libosmesa6 again"};
    constexpr int attributes[][2] = {{OSMESA_FORMAT, OSMESA_RGBA},
                                     {OSMESA_PROFILE, OSMESA_CORE_PROFILE},
                                     {OSMESA_CONTEXT_MAJOR_VERSION, 4},
                                     {OSMESA_CONTEXT_MINOR_VERSION, 5},
                                     {OSMESA_DEPTH_BITS, 0},
                                     {}};
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
  OSMesaContext context_ = nullptr;
  std::array<std::uint8_t, 4UL * unseen_size * unseen_size> unseen_pixels_{};
};

}  // namespace

bool osmesa_is_built_in() { return true; }
Result<std::unique_ptr<Context>> make_osmesa_context() { return open_context<OsMesaContext>(); }

}  // namespace throng::render::gl

#else

namespace throng::render::gl {

bool osmesa_is_built_in() { return false; }
Result<std::unique_ptr<Context>> make_osmesa_context() { return Error{"this build has no OSMesa"}; }

}  // namespace throng::render::gl

#endif
