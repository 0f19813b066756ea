#include "viewer_driver.hpp"

#include "desktop.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <unistd.h>

namespace drape::app {
namespace {

constexpr auto patience = std::chrono::seconds(60);  // ample, for machines under load
constexpr const char* statusName = "status.json";

/// The rectangle of a widget or a button; null when it does not exist.
Json rectOf(const Json& state, const std::string& name) {
  for (const char* kind : {"widgets", "buttons"}) {
    if (state[kind].contains(name)) {
      return state[kind][name];
    }
  }
  return nullptr;
}

}  // namespace

bool hasButton(const Json& state, const std::string& name) {
  return state["buttons"].contains(name);
}

bool says(const Json& state, const std::string& words) {
  return state["message"].get<std::string>().find(words) != std::string::npos;
}

bool isAttached(const Json& state) {
  return !state["attachment"].is_null();
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "drape-window-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("cannot make a temporary folder");
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

VirtualDisplay::VirtualDisplay(const std::string& size) {
  int ends[2] = {-1, -1};
  if (pipe(ends) != 0) {
    throw std::runtime_error("cannot make a pipe");
  }
  server_ = std::make_unique<Process>(ProcessOptions{
      .command = {"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", size, "-nolisten", "tcp", "-noreset"},
      .inheritedPipe = ends[1]});
  close(ends[1]);
  // The server writes its number when it is ready. When it cannot start, the pipe closes.
  char letter = 0;
  while (::read(ends[0], &letter, 1) == 1 && letter != '\n') {
    name_ += letter;
  }
  close(ends[0]);
  if (name_.empty()) {
    throw std::runtime_error("Xvfb does not start; the window tests need xvfb and xdotool");
  }
  name_ = ":" + name_;
}

ViewerDriver::ViewerDriver(const std::vector<std::string>& arguments, const std::string& size)
    : ViewerDriver(arguments, DriverOptions{.size = size}) {}

ViewerDriver::ViewerDriver(const std::vector<std::string>& arguments, const DriverOptions& options)
    : display_(std::string(options.size).replace(options.size.find(','), 1, "x") + "x24") {
  std::vector<std::string> command{DRAPE_PROGRAM, "--status", (folder_.path() / statusName).string()};
  if (options.windowSize) {
    command.insert(command.end(), {"--window-size", options.size});
  }
  command.insert(command.end(), arguments.begin(), arguments.end());
  viewer_ = std::make_unique<Process>(ProcessOptions{.command = command,
                                                     .environment = environmentOf(options),
                                                     .folder = folder_.path(),
                                                     .output = folder_.path() / "output.txt"});
  // The panels need some frames for their layout.
  waitUntil("the first frames", [](const Json& state) { return state["frame"] >= 3; });
}

/// The tests never touch the preferences and the fabrics of the user.
std::map<std::string, std::string> ViewerDriver::environmentOf(const DriverOptions& options) const {
  const std::filesystem::path home = options.home.empty() ? folder_.path() : options.home;
  std::map<std::string, std::string> environment{{"DISPLAY", display_.name()},
                                                 {"WAYLAND_DISPLAY", ""},
                                                 {"LC_ALL", options.locale},
                                                 {"XDG_STATE_HOME", (home / "state").string()},
                                                 {"XDG_CONFIG_HOME", (home / "config").string()}};
  if (!options.programs.empty()) {
    const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nothing changes the environment
    const bool exists = std::filesystem::exists(options.programs);
    environment["PATH"] = options.programs.string() + (exists && path != nullptr ? ":" + std::string(path) : "");
  }
  return environment;
}

std::optional<Json> ViewerDriver::read() const {
  const std::string text = contentOf(folder_.path() / statusName);
  if (text.empty()) {
    return std::nullopt;
  }
  return Json::parse(text);  // the file is replaced atomically, so it always parses
}

Json ViewerDriver::state() {
  return waitUntil("a state", [](const Json&) { return true; });
}

Json ViewerDriver::waitUntil(const std::string& what, const std::function<bool(const Json&)>& predicate) {
  const auto end = std::chrono::steady_clock::now() + patience;
  std::optional<Json> last;
  while (std::chrono::steady_clock::now() < end && viewer_->running()) {
    last = read();
    if (last && predicate(*last)) {
      return *last;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  throw std::runtime_error("waited in vain for " + what + "; output: " + contentOf(folder_.path() / "output.txt") +
                           "; last state: " + (last ? last->dump() : "none"));
}

// The file is up to 50 ms old, so its number of the frame alone does not say whether the last input was handled.
Json ViewerDriver::frames(int count) {
  const double now = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  const Json second = waitUntil("two frames", [&](const Json& s) { return s["input_seconds"] >= now; });
  const int wanted = second["frame"].get<int>() + count - 2;
  return waitUntil("more frames", [&](const Json& s) { return s["frame"] >= wanted; });
}

void ViewerDriver::xdotool(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"xdotool"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  if (runToEnd({.command = command, .environment = {{"DISPLAY", display_.name()}}}) != 0) {
    throw std::runtime_error("xdotool failed; the window tests need xvfb and xdotool");
  }
}

void ViewerDriver::betweenTwoFrames(const std::vector<std::vector<std::string>>& commands) {
  viewer_->suspend();
  for (const std::vector<std::string>& command : commands) {
    xdotool(command);
  }
  viewer_->resume();
  frames();
}

bool ViewerDriver::drop(const std::vector<std::string>& files) {
  const Json view = state()["view"];
  const double x = view["x"].get<double>() + 0.5 * view["width"].get<double>();
  const double y = view["y"].get<double>() + 0.5 * view["height"].get<double>();
  return dropFiles(display(), static_cast<int>(x), static_cast<int>(y), files);
}

void ViewerDriver::resize(int width, int height) {
  xdotool({"search", "--onlyvisible", "--name", "Drape", "windowsize", std::to_string(width), std::to_string(height)});
  waitUntil("the other size",
            [&](const Json& s) { return s["window"]["width"] == width && s["window"]["height"] == height; });
}

void ViewerDriver::move(const Place& place) {
  xdotool({"mousemove", std::to_string(std::lround(place.x)), std::to_string(std::lround(place.y))});
  frames();
}

// Frames pass between press and release, as with a real user: ImGui polls keys and buttons.
void ViewerDriver::press(int button) {
  xdotool({"mousedown", std::to_string(button)});
  frames();
}

void ViewerDriver::release(int button) {
  xdotool({"mouseup", std::to_string(button)});
  frames();
}

void ViewerDriver::click(const Place& place, int button) {
  move(place);
  press(button);
  release(button);
}

void ViewerDriver::doubleClick() {
  xdotool({"click", "--repeat", "2", "--delay", "80", "1"});
  frames();
}

void ViewerDriver::wheel(bool nearer) {
  xdotool({"click", nearer ? "4" : "5"});
  frames();
}

void ViewerDriver::key(const std::string& name) {
  holdKey(name);
  letKeyGo(name);
}

void ViewerDriver::tap(const std::string& name) {
  xdotool({"key", name});
}

void ViewerDriver::clearField() {
  xdotool({"key", "End"});
  xdotool({"key", "--repeat", "40", "--delay", "4", "BackSpace"});
  frames();
}

void ViewerDriver::holdKey(const std::string& name) {
  xdotool({"keydown", name});
  frames();
}

void ViewerDriver::letKeyGo(const std::string& name) {
  xdotool({"keyup", name});
  frames();
}

void ViewerDriver::type(const std::string& text) {
  xdotool({"type", text});
  frames();
  key("Return");
}

Place ViewerDriver::find(const std::string& name, double across, double margin) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < end) {
    const Json now = frames();
    const Json rect = rectOf(now, name);
    if (rect.is_null()) {
      throw std::runtime_error("there is no '" + name + "' in the panels");
    }
    const double y = rect["y"].get<double>() + rect["height"].get<double>() / 2.0;
    const double top = now["buttons"]["button.play"]["y"].get<double>() + 60.0;
    const double bottom = now["view"]["height"].get<double>() - margin;
    // Only the sections scroll; widgets above them, over the picture or in the status line do not.
    const bool overPicture = rect["x"].get<double>() >= now["view"]["x"].get<double>();
    const bool inHead = name == "scene.choice" || name == "button.play" || name == "button.step" ||
                        name == "button.reset" || name == "button.reset_all";
    const bool fixed = overPicture || name.starts_with("status.") || (y <= top && inHead);
    if (fixed || (rect["visible"] && y > top && y < bottom)) {
      return {rect["x"].get<double>() + across * rect["width"].get<double>(), y};
    }
    move({24.0, 300.0});  // over the labels, where the wheel scrolls
    wheel(y <= top);
  }
  throw std::runtime_error("'" + name + "' cannot be scrolled into sight");
}

Place ViewerDriver::onCloth() {
  const Json now = waitUntil("a place on the cloth", [](const Json& s) { return !s["cloth_points"].empty(); });
  return {now["cloth_points"][0]["x"], now["cloth_points"][0]["y"]};
}

Place ViewerDriver::besideCloth() {
  const Json now = waitUntil("a place beside the cloth", [](const Json& s) { return !s["free_point"].is_null(); });
  return {now["free_point"]["x"], now["free_point"]["y"]};
}

void clickHeadings(ViewerDriver& viewer, const std::vector<std::string>& sections) {
  constexpr double besideTheTitle = 60.0;
  for (const std::string& section : sections) {
    const Json heading = viewer.frames()["buttons"][section];
    viewer.click({heading["x"].get<double>() + besideTheTitle,
                  heading["y"].get<double>() + 0.5 * heading["height"].get<double>()});
  }
}

void quitWithQuestion(ViewerDriver& viewer) {
  viewer.tap("ctrl+q");
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "overlay.quit"); });
  viewer.tap("Return");
  EXPECT_EQ(viewer.process().waitFor(60.0), 0);
}

}  // namespace drape::app
