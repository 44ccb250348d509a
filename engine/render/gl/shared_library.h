#pragma once

#include <string>

namespace throng::render::gl {

/// Where leaks are reported, what a driver keeps for good must stay reachable, and so the driver loaded.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool keeps_drivers_loaded = true;
#else
inline constexpr bool keeps_drivers_loaded = false;
#endif

/// A library opened by name at run time, its symbols kept out of everyone else's sight (RTLD_LOCAL): OSMesa exports
/// its own gl* functions, which must never stand in for the system's.
class SharedLibrary {
 public:
  SharedLibrary() = default;
  explicit SharedLibrary(const char* name);
  SharedLibrary(SharedLibrary&& other) noexcept;
  SharedLibrary& operator=(SharedLibrary&& other) noexcept;
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;
  ~SharedLibrary();

  explicit operator bool() const { return library_ != nullptr; }

  /// The function of that name as `Function*`, or null.
  template <typename Function>
  Function* find(const char* name) const {
    return reinterpret_cast<Function*>(find_symbol(name));
  }

 private:
  void* find_symbol(const char* name) const;

  void* library_ = nullptr;
};

}  // namespace throng::render::gl
