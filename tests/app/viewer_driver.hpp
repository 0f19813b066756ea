#pragma once

#include "process.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {

using Json = nlohmann::json;

/// Whether a state has a button of that name.
[[nodiscard]] bool hasButton(const Json& state, const std::string& name);

/// Whether the message of a state contains these words.
[[nodiscard]] bool says(const Json& state, const std::string& words);

/// Whether the mouse pulls at the cloth.
[[nodiscard]] bool isAttached(const Json& state);

/// The text of a file; empty when it cannot be read.
[[nodiscard]] std::string contentOf(const std::filesystem::path& file);

/// A folder that is removed with this object.
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

/// An empty virtual display with a free number.
class VirtualDisplay {
 public:
  explicit VirtualDisplay(const std::string& size = "1280x800x24");
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::unique_ptr<Process> server_;
};

/// A position in the window.
struct Place {
  double x = 0.0;
  double y = 0.0;
};

/// How the viewer is started.
struct DriverOptions {
  std::string size = "1280,800";     ///< of the display
  bool windowSize = true;            ///< whether the window gets that size; else it chooses its own
  std::filesystem::path home{};      ///< the folder for preferences; empty: a new one
  std::string locale = "C.UTF-8";    ///< of the system
  std::filesystem::path programs{};  ///< comes first in PATH; a folder that does not exist: PATH has nothing else
};

/// The viewer on a virtual display, controlled with mouse and keyboard, and observed through its status file.
class ViewerDriver {
 public:
  /// `size` of the window, on a display that is at least as large.
  explicit ViewerDriver(const std::vector<std::string>& arguments, const std::string& size = "1280,800");
  ViewerDriver(const std::vector<std::string>& arguments, const DriverOptions& options);

  /// The newest state.
  [[nodiscard]] Json state();
  /// Waits until the state satisfies the predicate and returns it. Fails the test with `what` after a while.
  Json waitUntil(const std::string& what, const std::function<bool(const Json&)>& predicate);
  /// Waits for this number of frames and returns the state.
  Json frames(int count = 3);

  void move(const Place& place);
  void press(int button = 1);
  void release(int button = 1);
  void click(const Place& place, int button = 1);
  /// Two clicks at the mouse position, as fast as possible.
  void doubleClick();
  void wheel(bool nearer);
  /// Presses a key that acts on press.
  void key(const std::string& name);
  /// Presses and releases a key at once: one that may end the viewer, or that repeats while it is held.
  void tap(const std::string& name);
  void holdKey(const std::string& name);
  void letKeyGo(const std::string& name);
  /// Sends any xdotool command without waiting for its effect.
  void send(const std::vector<std::string>& arguments) { xdotool(arguments); }
  /// Sends xdotool commands while the viewer is stopped, as if they came between two frames of a very slow machine.
  void betweenTwoFrames(const std::vector<std::vector<std::string>>& commands);
  /// Drops files into the middle of the picture. Returns whether the window accepted them.
  [[nodiscard]] bool drop(const std::vector<std::string>& files);
  /// Resizes the window.
  void resize(int width, int height);
  /// Types text and Enter into the field with the keyboard focus.
  void type(const std::string& text);
  /// Deletes up to 40 characters of the field that has the focus.
  void clearField();

  /// The position of a widget or a button, scrolled into view if needed. @param margin distance from the lower end of
  /// the panel, where a long message may lie [pixels]
  Place find(const std::string& name, double across = 0.5, double margin = 70.0);
  /// A position on the cloth, and one beside it.
  Place onCloth();
  Place besideCloth();

  [[nodiscard]] Process& process() { return *viewer_; }
  [[nodiscard]] const std::string& display() const { return display_.name(); }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  [[nodiscard]] std::map<std::string, std::string> environmentOf(const DriverOptions& options) const;
  void xdotool(const std::vector<std::string>& arguments);
  [[nodiscard]] std::optional<Json> read() const;

  TemporaryFolder folder_;
  VirtualDisplay display_;
  std::unique_ptr<Process> viewer_;
};

/// Opens or closes sections of the panel by a click on the heading of each ("section.material").
void clickHeadings(ViewerDriver& viewer, const std::vector<std::string>& sections);

/// Quits the viewer, which asks first because changes would be lost, and waits for its end.
void quitWithQuestion(ViewerDriver& viewer);

}  // namespace drape::app
