#include "engine/render/gl/shared_library.h"

#include <string>

#if !defined(_WIN32)
#include <dlfcn.h>
#endif

namespace throng::render::gl {

#if defined(_WIN32)

void CloseLibrary::operator()(void*) const {}

bool is_installed(const char*) { return false; }

Result<SharedLibrary> open_library(const char* name, const char*) {
  return Error{std::string(name) + " is not there on Windows; open a window"};
}

void* address_in(const SharedLibrary&, const char*) { return nullptr; }

#else

namespace {

// A library that another one needs may be missing as well: then the reason names that one. The second form is musl's.
bool says_that_it_is_missing(const std::string& reason, const std::string& name) {
  return reason.find(name + ": cannot open shared object file: No such file") != std::string::npos ||
         reason.find(name + ": No such file") != std::string::npos;
}

SharedLibrary open(const char* name) {
  return SharedLibrary(dlopen(name, RTLD_NOW | RTLD_LOCAL | (keeps_drivers_loaded ? RTLD_NODELETE : 0)));
}

std::string reason_of_failure() {
  const char* said = dlerror();
  return said == nullptr ? "no reason given" : said;
}

}  // namespace

void CloseLibrary::operator()(void* library) const { dlclose(library); }

bool is_installed(const char* name) {
  return open(name) != nullptr || !says_that_it_is_missing(reason_of_failure(), name);
}

Result<SharedLibrary> open_library(const char* name, const char* package) {
  SharedLibrary library = open(name);
  if (library) return library;
  const std::string reason = reason_of_failure();
  const std::string remedy = std::string("install ") + package;
  if (says_that_it_is_missing(reason, name)) return Error{std::string(name) + " is not installed, " + remedy};
  return Error{std::string(name) + " is installed and cannot be loaded (" + reason + "), " + remedy + " again"};
}

void* address_in(const SharedLibrary& library, const char* name) { return dlsym(library.get(), name); }

#endif

}  // namespace throng::render::gl
