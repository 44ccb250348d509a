#include "tests/window/screen.h"

#include <memory>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace throng::app {
namespace {

struct Destroy {
  void operator()(XImage* image) const { XDestroyImage(image); }
};

// Screens of Xvfb are of 24 bits: 0x00RRGGBB.
render::Image converted(XImage& shown) {
  render::Image image = render::Image::blank(shown.width, shown.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const unsigned long value = XGetPixel(&shown, x, y);
      std::uint8_t* const pixel = image.pixel(x, y);
      for (int channel = 0; channel < 3; ++channel) {
        pixel[channel] = static_cast<std::uint8_t>(value >> (16 - 8 * channel));
      }
      pixel[3] = 255;
    }
  }
  return image;
}

}  // namespace

std::optional<render::Image> picture_of_screen(const std::string& display, glm::ivec2 size) {
  const std::unique_ptr<Display, int (*)(Display*)> connection(XOpenDisplay(display.c_str()), XCloseDisplay);
  if (connection == nullptr) return {};
  XWindowAttributes root{};
  XGetWindowAttributes(connection.get(), DefaultRootWindow(connection.get()), &root);
  if (root.width < size.x || root.height < size.y) return {};
  const std::unique_ptr<XImage, Destroy> shown(XGetImage(connection.get(), DefaultRootWindow(connection.get()), 0, 0,
                                                         static_cast<unsigned>(size.x), static_cast<unsigned>(size.y),
                                                         AllPlanes, ZPixmap));
  if (shown == nullptr) return {};
  return converted(*shown);
}

}  // namespace throng::app
