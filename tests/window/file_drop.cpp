#include "tests/window/file_drop.h"

#include <memory>
#include <thread>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace throng::app {
namespace {

constexpr long version = 5;

/// The source of a drop: a window that owns the XDND selection while the target asks for it.
class DropSource {
 public:
  DropSource(Display& display, std::string file)
      : display_(&display),
        window_(XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0)),
        uri_("file://" + std::move(file) + "\r\n") {
    XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
  }

  bool drop(Deadline deadline) {
    target_ = window_that_takes_drops();
    if (target_ == 0) return false;
    send("XdndEnter", version << 24, static_cast<long>(atom("text/uri-list")));
    send("XdndPosition", 0, (400L << 16) | 300L, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
    if (!answer_until("XdndStatus", deadline)) return false;
    send("XdndDrop", 0, CurrentTime);
    return answer_until("XdndFinished", deadline);
  }

 private:
  Atom atom(const char* name) { return XInternAtom(display_, name, False); }

  bool takes_drops(Window window) {
    int count = 0;
    Atom* const properties = XListProperties(display_, window, &count);
    bool aware = false;
    for (int i = 0; i < count; ++i) aware |= properties[i] == atom("XdndAware");
    if (properties != nullptr) XFree(properties);
    return aware;
  }

  Window window_that_takes_drops() {
    Window root = 0, parent = 0, found = 0, *children = nullptr;
    unsigned count = 0;
    XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count);
    for (unsigned i = 0; i < count; ++i) found = takes_drops(children[i]) ? children[i] : found;
    if (children != nullptr) XFree(children);
    return found;
  }

  void send(const char* message, long first, long second = 0, long third = 0, long fourth = 0) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    const long words[] = {static_cast<long>(window_), first, second, third, fourth};
    for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = words[i];
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  void hand_over(const XSelectionRequestEvent& request) {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(uri_.data()), static_cast<int>(uri_.size()));
    XEvent event{};
    event.xselection = {.type = SelectionNotify,
                        .serial = 0,
                        .send_event = True,
                        .display = display_,
                        .requestor = request.requestor,
                        .selection = request.selection,
                        .target = request.target,
                        .property = request.property,
                        .time = request.time};
    XSendEvent(display_, request.requestor, False, NoEventMask, &event);
    XFlush(display_);
  }

  bool answer_until(const char* message, Deadline deadline) {
    for (; std::chrono::steady_clock::now() < deadline; std::this_thread::sleep_for(std::chrono::milliseconds(2))) {
      while (XPending(display_) > 0) {
        XEvent event;
        XNextEvent(display_, &event);
        if (event.type == SelectionRequest) hand_over(event.xselectionrequest);
        if (event.type == ClientMessage && event.xclient.message_type == atom(message)) return true;
      }
    }
    return false;
  }

  Display* display_;
  Window window_;
  Window target_ = 0;
  std::string uri_;
};

}  // namespace

bool drop_file(const std::string& display, const std::string& file, Deadline deadline) {
  const std::unique_ptr<Display, int (*)(Display*)> connection(XOpenDisplay(display.c_str()), XCloseDisplay);
  return connection != nullptr && DropSource(*connection, file).drop(deadline);
}

}  // namespace throng::app
