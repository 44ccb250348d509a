#pragma once

#include <memory>

#include "engine/base/result.h"

namespace throng::render::gl {

/// Says whether drivers stay loaded. They do if leaks are reported, because memory that a driver never frees must then
/// stay reachable.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool keeps_drivers_loaded = true;
#else
inline constexpr bool keeps_drivers_loaded = false;
#endif

struct CloseLibrary {
  void operator()(void* library) const;
};

/// A library that was opened by name at run time, or null.
using SharedLibrary = std::unique_ptr<void, CloseLibrary>;

/// Says whether a library is on this machine, even if it cannot be loaded.
bool is_installed(const char* name);

/// Opens a library. No other library sees its symbols (RTLD_LOCAL), because OSMesa exports gl* functions of its own,
/// which must never stand in for the system's. Errors: it is not installed, and the error names the `package` that has
/// it; or it is there and cannot be loaded, and the error says why. On Windows none is opened.
Result<SharedLibrary> open_library(const char* name, const char* package);

/// Returns where a function or a variable of a library is, or null.
void* address_in(const SharedLibrary& library, const char* name);

/// Sets `function` to the function of that name, or to null.
template <typename Function>
void find_function(const SharedLibrary& library, Function*& function, const char* name) {
  function = reinterpret_cast<Function*>(address_in(library, name));
}

}  // namespace throng::render::gl
