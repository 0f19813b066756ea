// What the window keeps: files, preferences, and the steps of undo.
#include "app/scene_saving.hpp"
#include "app/viewer/free_name.hpp"
#include "app/viewer/viewer.hpp"
#include "messages/error.hpp"
#include "ui/scene_changes.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace drape::app {
namespace {

/// Whether a part of the title bar of a window at that place would be on a monitor, so that the user can reach it.
bool isReachable(const WindowPlace& place) {
  constexpr int reach = 40;  // [window units]
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  return std::any_of(monitors, monitors + count, [&](GLFWmonitor* monitor) {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
    return place.x + place.width > x + reach && place.x < x + width - reach && place.y >= y - reach &&
           place.y < y + height - reach;
  });
}

/// The size, at most that of the largest monitor.
std::pair<int, int> fittingSize(const WindowPlace& place) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  int widest = 0;
  int highest = 0;
  for (int i = 0; i < count; ++i) {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    glfwGetMonitorWorkarea(monitors[i], &x, &y, &width, &height);
    widest = std::max(widest, width);
    highest = std::max(highest, height);
  }
  return count == 0 ? std::pair(place.width, place.height)
                    : std::pair(std::min(place.width, widest), std::min(place.height, highest));
}

WindowPlace placeOf(GLFWwindow* window) {
  WindowPlace place;
  glfwGetWindowPos(window, &place.x, &place.y);
  glfwGetWindowSize(window, &place.width, &place.height);
  return place;
}

/// The state of the user, as a scene file has it. The number of threads and the error check belong to this computer.
scene::SceneNow sceneNow(const session::UserState& state, const session::Snapshot& snapshot) {
  scene::SceneNow now{state.settings, snapshot.model->pinned, *state.pinPaths, {}};
  settings::Settings opened = snapshot.scene->description.settings;
  const int threadsOfScene = opened.step.threads;
  const bool checkOfScene = opened.measures.errorCheck;
  ui::useWindowDefaults(opened);
  if (now.settings.step.threads == opened.step.threads) {
    now.settings.step.threads = threadsOfScene;
  }
  if (now.settings.measures.errorCheck == opened.measures.errorCheck) {
    now.settings.measures.errorCheck = checkOfScene;
  }
  for (const session::BodyChoice& body : state.bodies) {
    now.bodies.push_back({body.on, body.shift, body.surface, body.figure});
  }
  now.sewing = *state.sewing;
  return now;
}

bool isFile(const std::string& name) {
  std::error_code error;
  return std::filesystem::is_regular_file(name, error);
}

}  // namespace

void Viewer::on(const ui::SaveSceneRequest& request, const session::Snapshot& snapshot) {
  try {
    std::filesystem::path file = savedFile_;
    if (!request.path.empty()) {
      file = sceneFile(request.path);
    } else if (file.empty()) {
      file = freeName(std::filesystem::current_path(), snapshot.scene->description.name, ".toml");
    }
    std::error_code error;
    if (file != savedFile_ && !request.mayReplace && std::filesystem::exists(file, error)) {
      panels_.askToReplace(file.string());
      return;
    }
    const session::UserState& state = undo_.present();
    text::Sentence notice("Saved {}", file.string());
    scene::SceneNow now = sceneNow(state, snapshot);
    now.camera = controller_.viewForScene();
    for (const text::Sentence& note : saveScene(*snapshot.scene, std::move(now), file, Existing::Replaced,
                                                snapshot.placedStart ? *snapshot.placedStart : std::vector<Vec3>())) {
      notice.append(". ", note);
    }
    savedFile_ = file;
    savedState_ = state;
    noteFile(file);
    stats_.error = {};
    showNotice(notice);
  } catch (const std::exception& error) {
    showFailure(error);
  }
}

void Viewer::on(const ui::ThemeRequest& request, const session::Snapshot& /*snapshot*/) {
  panels_.useTheme(request.theme);
}

void Viewer::on(const ui::LanguageRequest& request, const session::Snapshot& /*snapshot*/) {
  if (const locale::Language* chosen = locale::findLanguage(request.name)) {
    panels_.useLanguage(*chosen);
    showTitle();
    preferences_.language = chosen->name;
  }
}

void Viewer::watchChanges(const session::Snapshot& snapshot, ui::UiOutput& output) {
  undo_.noteCommands(output.commands);
  const bool settled =
      !panels_.isBusy() && !controller_.holdsBody() && !controller_.placing().isBuilding() && stats_.loading.empty();
  undo_.watch(snapshot, panels_.settingsInForce(snapshot), settled, glfwGetTime(), output);
}

void Viewer::undoOrRedo(ui::UiAction action, const session::Snapshot& snapshot) {
  ui::UiOutput output;
  output.hint = action == ui::UiAction::Undo ? undo_.undo(output) : undo_.redo(output);
  execute(output, snapshot);
}

/// Turns the turntable, and tells the panels about camera and selection.
void Viewer::followCamera(const session::Snapshot& snapshot) {
  constexpr double longestPause = 0.1;  // a slow picture does not make the camera jump [s]
  const double now = glfwGetTime();
  controller_.turn(std::min(now - lastTurn_, longestPause), snapshot);
  lastTurn_ = now;
  if (controller_.turns()) {
    lastChange_ = Clock::now();
  }
  stats_.selection = controller_.selection(snapshot);
  stats_.placing = controller_.placingView(snapshot);
  stats_.sewing = controller_.sewingView(snapshot);
  stats_.camera = {controller_.camera().isOrthographic(), controller_.turns(), {}};
  if (const SceneViews* views = preferences_.viewsOf(sceneKey(snapshot))) {
    for (std::size_t i = 0; i < views->views.size(); ++i) {
      stats_.camera.hasView[i] = views->views[i].has_value();
    }
  }
}

std::string Viewer::sceneKey(const session::Snapshot& snapshot) const {
  const scene::SceneParts& parts = snapshot.scene->description.parts;
  const std::string& name = parts.scene.empty() ? parts.cloth : parts.scene;
  return isFile(name) ? std::filesystem::absolute(name).lexically_normal().string() : name;
}

void Viewer::keepView(std::size_t place, const session::Snapshot& snapshot) {
  preferences_.keepView(sceneKey(snapshot), place, controller_.camera().pose());
  showNotice(text::Sentence("This is now view {} of the scene", place + 1));
}

void Viewer::recallView(std::size_t place, const session::Snapshot& snapshot) {
  const SceneViews* views = preferences_.viewsOf(sceneKey(snapshot));
  if (views == nullptr || !views->views[place]) {
    showNotice(text::Sentence("There is no view {} yet; Ctrl+F{} keeps the present one", place + 1, place + 5));
    return;
  }
  controller_.recall(render::Camera(*views->views[place]));
}

bool Viewer::hasUnsavedChanges(const session::Snapshot& snapshot) const {
  return openedScene_ && ui::hasChanges(snapshot, *openedScene_) &&
         (!savedState_ || ui::hasChanges(undo_.present(), *savedState_));
}

void Viewer::openFileDialog() {
  std::error_code error;
  const bool exists = std::filesystem::is_directory(preferences_.folder, error);
  if (!dialog_.open(exists ? preferences_.folder : std::string(), panels_.language().texts)) {
    panels_.showOpenField();
    showNotice(
        text::Sentence("The file dialog needs the program {}, which is not installed. Type the path in the field "
                       "\"Open a file\", or drop a file on the window",
                       FileDialog::program));
  }
}

void Viewer::takeChosenFiles(const session::Snapshot& snapshot) {
  const std::optional<FileDialog::Outcome> outcome = dialog_.poll();
  if (!outcome) {
    return;
  }
  if (!outcome->error.empty()) {
    panels_.showOpenField();
    showNotice(text::Sentence("{}. Type the path in the field \"Open a file\"", outcome->error));
  } else if (!outcome->files.empty()) {
    on(ui::DroppedRequest{outcome->files}, snapshot);
  }
}

/// A damaged file of preferences is not replaced because of the files on the command line.
void Viewer::noteOpenedFiles(const scene::SceneParts& parts) {
  if (frameCount_ == 0 && !preferencesFile_.problem().empty()) {
    return;
  }
  const std::vector<scene::SceneInfo> builtIn = scene::sceneList();
  const auto isBuiltIn = [&](const scene::SceneInfo& scene) { return scene.name == parts.scene; };
  for (const std::string& body : parts.bodies) {
    noteFile(body);
  }
  if (isFile(parts.cloth)) {
    noteFile(parts.cloth);
  }
  if (isFile(parts.scene) && std::ranges::none_of(builtIn, isBuiltIn)) {
    noteFile(parts.scene);
  }
}

void Viewer::noteFile(const std::filesystem::path& file) {
  preferences_.noteFile(file);
  preferences_.folder = std::filesystem::path(preferences_.recentFiles.front()).parent_path().string();
  stats_.recentFiles = preferences_.recentFiles;
}

void Viewer::restorePreferences(const ViewerOptions& options) {
  const locale::Language* kept = locale::findLanguage(preferences_.language);
  panels_.useLanguage(options.language ? *options.language : kept != nullptr ? *kept : options.usualLanguage);
  if (keepsWindowPlace_ && preferences_.window) {
    const auto [width, height] = fittingSize(*preferences_.window);
    glfwSetWindowSize(window_.window(), width, height);
    if (isReachable(*preferences_.window)) {
      glfwSetWindowPos(window_.window(), preferences_.window->x, preferences_.window->y);
    }
  }
  panels_.useTheme(preferences_.theme);
  panels_.restoreSections(preferences_.sections);
  stats_.recentFiles = preferences_.recentFiles;
  if (!preferencesFile_.problem().empty()) {
    showError(text::Sentence::verbatim(preferencesFile_.problem()));
  }
}

/// Writes the preferences as soon as one changes, and the user has let go of the window.
void Viewer::keepPreferences() {
  constexpr auto pause = std::chrono::milliseconds(300);
  if (!firstPlace_ && frameCount_ > 0) {  // before the user can move the window
    firstPlace_ = placeOf(window_.window());
  }
  const bool ends = glfwWindowShouldClose(window_.window()) == GLFW_TRUE;
  if (!ends && Clock::now() < nextKeep_) {
    return;
  }
  nextKeep_ = Clock::now() + pause;
  preferences_.theme = panels_.theme();
  preferences_.sections = panels_.sections();
  const bool isUsual = glfwGetWindowAttrib(window_.window(), GLFW_ICONIFIED) == GLFW_FALSE &&
                       glfwGetWindowAttrib(window_.window(), GLFW_MAXIMIZED) == GLFW_FALSE;
  if (const WindowPlace place = placeOf(window_.window());
      keepsWindowPlace_ && isUsual && firstPlace_ && place != *firstPlace_) {
    preferences_.window = place;
  }
  if (const std::string problem = preferencesFile_.keep(preferences_); !problem.empty()) {
    showError(text::Sentence::verbatim(problem));
  }
}

}  // namespace drape::app
