#include "engine/render/gl/shared_library.h"

#include <string>

namespace throng::render::gl {
namespace {

// A library that another one needs may be missing as well: then the reason names that one. The second form is musl's.
bool says_that_it_is_missing(const std::string& reason, const std::string& name) {
  return reason.find(name + ": cannot open shared object file: No such file") != std::string::npos ||
         reason.find(name + ": No such file") != std::string::npos;
}

}  // namespace

Result<SharedLibrary> open_library(const char* name, const char* package) {
  SharedLibrary library(dlopen(name, RTLD_NOW | RTLD_LOCAL | (keeps_drivers_loaded ? RTLD_NODELETE : 0)));
  if (library) return library;
  const char* said = dlerror();
  const std::string reason = said == nullptr ? "no reason given" : said;
  const std::string remedy = std::string("install ") + package;
  if (says_that_it_is_missing(reason, name)) return Error{std::string(name) + " is not installed, " + remedy};
  return Error{std::string(name) + " is installed and cannot be loaded (" + reason + "), " + remedy + " again"};
}

}  // namespace throng::render::gl
