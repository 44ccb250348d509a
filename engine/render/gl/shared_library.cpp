#include "engine/render/gl/shared_library.h"

#include <utility>

#include <dlfcn.h>

namespace throng::render::gl {

SharedLibrary::SharedLibrary(const char* name)
    : library_(dlopen(name, RTLD_NOW | RTLD_LOCAL | (keeps_drivers_loaded ? RTLD_NODELETE : 0))) {}

SharedLibrary::SharedLibrary(SharedLibrary&& other) noexcept : library_(std::exchange(other.library_, nullptr)) {}

SharedLibrary& SharedLibrary::operator=(SharedLibrary&& other) noexcept {
  std::swap(library_, other.library_);
  return *this;
}

SharedLibrary::~SharedLibrary() {
  if (library_ != nullptr) dlclose(library_);
}

void* SharedLibrary::find_symbol(const char* name) const { return dlsym(library_, name); }

}  // namespace throng::render::gl
