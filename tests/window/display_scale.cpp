#include "tests/window/display_scale.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace throng::app {

std::shared_ptr<void> with_dots_per_inch(const std::string& display, int dots) {
  ::Display* const connection = XOpenDisplay(display.c_str());
  if (connection == nullptr) return nullptr;
  const std::string resources = "Xft.dpi:\t" + std::to_string(dots) + "\n";
  XChangeProperty(connection, DefaultRootWindow(connection), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(resources.data()), static_cast<int>(resources.size()));
  XSync(connection, False);
  return {connection, [](void* opened) { XCloseDisplay(static_cast<::Display*>(opened)); }};
}

}  // namespace throng::app
