#pragma once

#include "process.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape {

using Json = nlohmann::json;

/// A folder that goes away with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A virtual display with nothing on it, on a number that is free.
class VirtualDisplay {
 public:
  explicit VirtualDisplay(const std::string& size = "1280x800x24");
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::unique_ptr<Process> server_;
};

/// A place in the window.
struct Place {
  double x = 0.0;
  double y = 0.0;
};

/// The viewer on a virtual display, used with mouse and keyboard, and looked at through its state file.
class ViewerDriver {
 public:
  /// `size` of the window, on a display that is at least as large.
  explicit ViewerDriver(const std::vector<std::string>& arguments, const std::string& size = "1280,800");

  /// The newest state.
  [[nodiscard]] Json state();
  /// Waits until the state satisfies the predicate and gives that state; fails the test, naming `what`, after a while.
  Json waitUntil(const std::string& what, const std::function<bool(const Json&)>& predicate);
  /// Waits until so many more frames have been drawn, and gives the state.
  Json frames(int count = 3);

  void move(const Place& place);
  void press(int button = 1);
  void release(int button = 1);
  void click(const Place& place, int button = 1);
  /// Two clicks where the mouse is, as quickly as they can be sent.
  void doubleClick();
  void wheel(bool nearer);
  /// A key that acts when it goes down.
  void key(const std::string& name);
  /// The same when the viewer may be gone afterwards.
  void tap(const std::string& name);
  void holdKey(const std::string& name);
  void letKeyGo(const std::string& name);
  /// Any xdotool command, without waiting for what comes of it.
  void send(const std::vector<std::string>& arguments) { xdotool(arguments); }
  /// Sends xdotool commands while the viewer stands still, as if they came between two frames of a very slow machine.
  void betweenTwoFrames(const std::vector<std::vector<std::string>>& commands);
  /// Drops files into the middle of the picture, and gives back whether the window took them.
  [[nodiscard]] bool drop(const std::vector<std::string>& files);
  /// Gives the window another size.
  void resize(int width, int height);
  /// Text and Enter into a field that has the keyboard.
  void type(const std::string& text);

  /// Where a widget or a button is, scrolled into sight when need be.
  Place find(const std::string& name, double across = 0.5);
  /// A place where the cloth can be taken, and one beside it.
  Place onCloth();
  Place besideCloth();

  [[nodiscard]] Process& process() { return *viewer_; }
  [[nodiscard]] const std::string& display() const { return display_.name(); }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  void xdotool(const std::vector<std::string>& arguments);
  [[nodiscard]] std::optional<Json> read() const;

  TemporaryFolder folder_;
  VirtualDisplay display_;
  std::unique_ptr<Process> viewer_;
};

}  // namespace drape
