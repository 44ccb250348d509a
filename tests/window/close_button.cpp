#include "tests/window/close_button.h"

#include <memory>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace throng::app {
namespace {

bool listens(::Display* display, Window window, Atom asked) {
  Atom* protocols = nullptr;
  int count = 0;
  if (XGetWMProtocols(display, window, &protocols, &count) == 0) return false;
  bool found = false;
  for (int i = 0; i < count; ++i) found |= protocols[i] == asked;
  XFree(protocols);
  return found;
}

bool ask(::Display* display, Window window) {
  const Atom asked = XInternAtom(display, "WM_DELETE_WINDOW", False);
  if (!listens(display, window, asked)) return false;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(asked);
  XSendEvent(display, window, False, NoEventMask, &event);
  XFlush(display);
  return true;
}

}  // namespace

bool press_close_button(const std::string& name) {
  const std::unique_ptr<::Display, int (*)(::Display*)> display(XOpenDisplay(name.c_str()), XCloseDisplay);
  if (display == nullptr) return false;
  Window root = 0, parent = 0, *children = nullptr;
  unsigned count = 0;
  XQueryTree(display.get(), DefaultRootWindow(display.get()), &root, &parent, &children, &count);
  bool asked = false;
  for (unsigned i = 0; i < count; ++i) asked |= ask(display.get(), children[i]);
  if (children != nullptr) XFree(children);
  return asked;
}

}  // namespace throng::app
