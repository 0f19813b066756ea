#include "desktop.hpp"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace drape::app {
namespace {

constexpr auto patience = std::chrono::seconds(60);  // far more than is needed, for machines under load
constexpr long protocolVersion = 5;

struct CloseDisplay {
  void operator()(Display* display) const { XCloseDisplay(display); }
};

/// The address of a file: every byte but letters, digits and a few signs is escaped.
std::string addressOf(const std::string& file) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string address = "file://";
  for (const char sign : file) {
    const auto byte = static_cast<unsigned char>(sign);
    if (std::isalnum(byte) != 0 || std::string_view("/.-_~").find(sign) != std::string_view::npos) {
      address += sign;
    } else {
      address += {'%', digits[byte / 16], digits[byte % 16]};
    }
  }
  return address;
}

std::string addressesOf(const std::vector<std::string>& files) {
  std::string list;
  for (const std::string& file : files) {
    list += addressOf(file) + "\r\n";
  }
  return list;
}

/// Another program on the viewer's display.
class Neighbour {
 public:
  explicit Neighbour(const std::string& name) : display_(XOpenDisplay(name.c_str())) {
    if (!display_) {
      throw std::runtime_error("there is no display " + name);
    }
    const Window root = DefaultRootWindow(display_.get());
    window_ = XCreateSimpleWindow(display_.get(), root, 0, 0, 1, 1, 0, 0, 0);
    viewer_ = windowThatTakesFiles(root);
    if (viewer_ == 0) {
      throw std::runtime_error("no window on " + name + " takes files");
    }
  }

  bool drop(int x, int y, const std::string& addresses) {
    XSetSelectionOwner(display_.get(), atom("XdndSelection"), window_, CurrentTime);
    const long source = static_cast<long>(window_);
    send("XdndEnter", {source, protocolVersion << 24, number("text/uri-list")});
    send("XdndPosition", {source, 0, (static_cast<long>(x) << 16) | y, CurrentTime, number("XdndActionCopy")});
    const bool wanted = (answer("XdndStatus", addresses).data.l[1] & 1) != 0;
    if (!wanted) {
      send("XdndLeave", {source});
      return false;
    }
    send("XdndDrop", {source, 0, CurrentTime});
    // GLFW answers with the length of the list where the protocol wants a 1.
    return answer("XdndFinished", addresses).data.l[1] != 0;
  }

  std::pair<int, int> smallestSize() {
    XSizeHints hints{};
    long supplied = 0;
    if (XGetWMNormalHints(display_.get(), viewer_, &hints, &supplied) == 0 || (hints.flags & PMinSize) == 0) {
      return {0, 0};
    }
    return {hints.min_width, hints.min_height};
  }

  void askToClose() { send("WM_PROTOCOLS", {number("WM_DELETE_WINDOW"), CurrentTime}); }

 private:
  Atom atom(const char* name) { return XInternAtom(display_.get(), name, False); }
  long number(const char* name) { return static_cast<long>(atom(name)); }

  /// The first window, from this one down, that says that files can be dropped on it; 0: none.
  Window windowThatTakesFiles(Window from) {
    if (takesFiles(from)) {
      return from;
    }
    Window root = 0;
    Window parent = 0;
    Window* children = nullptr;
    unsigned int count = 0;
    if (XQueryTree(display_.get(), from, &root, &parent, &children, &count) == 0 || children == nullptr) {
      return 0;
    }
    Window found = 0;
    for (unsigned int i = 0; i < count && found == 0; ++i) {
      found = windowThatTakesFiles(children[i]);
    }
    XFree(children);
    return found;
  }

  bool takesFiles(Window window) {
    Atom type = 0;
    int format = 0;
    unsigned long count = 0;
    unsigned long left = 0;
    unsigned char* value = nullptr;
    XGetWindowProperty(display_.get(), window, atom("XdndAware"), 0, 1, False, AnyPropertyType, &type, &format, &count,
                       &left, &value);
    if (value != nullptr) {
      XFree(value);
    }
    return type != 0;
  }

  void send(const char* message, const std::array<long, 5>& data) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = viewer_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    std::copy(data.begin(), data.end(), event.xclient.data.l);
    XSendEvent(display_.get(), viewer_, False, NoEventMask, &event);
    XFlush(display_.get());
  }

  /// Waits for a message of the viewer and hands over the addresses when it asks for them in the meantime.
  XClientMessageEvent answer(const char* message, const std::string& addresses) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
      if (XPending(display_.get()) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        continue;
      }
      XEvent event{};
      XNextEvent(display_.get(), &event);
      if (event.type == SelectionRequest) {
        handOver(event.xselectionrequest, addresses);
      } else if (event.type == ClientMessage && event.xclient.message_type == atom(message)) {
        return event.xclient;
      }
    }
    throw std::runtime_error(std::string("the window does not answer with ") + message);
  }

  void handOver(const XSelectionRequestEvent& request, const std::string& addresses) {
    XChangeProperty(display_.get(), request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(addresses.data()), static_cast<int>(addresses.size()));
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    XSendEvent(display_.get(), request.requestor, False, NoEventMask, &event);
    XFlush(display_.get());
  }

  std::unique_ptr<Display, CloseDisplay> display_;
  Window window_ = 0;  // of this program; nobody sees it
  Window viewer_ = 0;
};

}  // namespace

bool dropFiles(const std::string& display, int x, int y, const std::vector<std::string>& files) {
  return Neighbour(display).drop(x, y, addressesOf(files));
}

void askToClose(const std::string& display) {
  Neighbour(display).askToClose();
}

std::pair<int, int> smallestSize(const std::string& display) {
  return Neighbour(display).smallestSize();
}

}  // namespace drape::app
