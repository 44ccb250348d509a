#pragma once

#include <string>

namespace throng::render::gl {

/// Says whether drivers stay loaded. Where leaks are reported, memory that a driver never frees must stay reachable.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool keeps_drivers_loaded = true;
#else
inline constexpr bool keeps_drivers_loaded = false;
#endif

/// Opens a library by name at run time. No other library sees its symbols (RTLD_LOCAL), because OSMesa exports gl*
/// functions of its own, which must never stand in for the system's.
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

  /// Gives the function of that name, or null.
  template <typename Function>
  Function* find(const char* name) const {
    return reinterpret_cast<Function*>(find_symbol(name));
  }

 private:
  void* find_symbol(const char* name) const;

  void* library_ = nullptr;
};

}  // namespace throng::render::gl
