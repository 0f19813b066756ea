#include "app/viewer/viewer.hpp"

#include "app/session_log.hpp"
#include "app/viewer/process_age.hpp"
#include "messages/sim_error_text.hpp"
#include "settings/settings_table.hpp"
#include "ui/names_in_words.hpp"

#include <GL/glew.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <thread>
#include <utility>

namespace drape::app {
namespace {

constexpr int usualWidth = 1440;  // of the window at scale 1
constexpr int usualHeight = 900;
constexpr int smallestWidth = 640;  // of the window at scale 1, so that all panels can be used
constexpr int smallestHeight = 480;
constexpr float maxLimitScale = 1.25F;  // of the smallest size; larger text must fit on small screens too
constexpr auto noticeTime = std::chrono::seconds(8);
constexpr double frameSmoothing = 0.1;  // weight of the newest frame in the average

struct Monitor {
  int rows = 0;
  int workWidth = usualWidth;
  int workHeight = usualHeight;
  int refreshRate = 60;  // [Hz]
};

Monitor measureMonitor() {
  Monitor result;
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode == nullptr) {
    return result;
  }
  int x = 0;
  int y = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &result.workWidth, &result.workHeight);
  result.rows = std::min(mode->width, mode->height);  // it may be in portrait orientation
  result.refreshRate = std::clamp(mode->refreshRate, 30, 240);
  return result;
}

/// Opens the window in the requested size, or in a suitable size for the monitor.
void resizeWindow(GLFWwindow* window, const ViewerOptions& options, const std::optional<WindowPlace>& kept) {
  if (options.windowSize || kept) {
    return;
  }
  const Monitor monitor = measureMonitor();
  float contentScale = 1.0F;
  glfwGetWindowContentScale(window, &contentScale, nullptr);
  const float scale = ui::uiScale(0.0, contentScale, monitor.rows);
  glfwSetWindowSize(window, std::min(static_cast<int>(usualWidth * scale), monitor.workWidth),
                    std::min(static_cast<int>(usualHeight * scale), monitor.workHeight));
}

std::pair<int, int> openingSize(const ViewerOptions& options) {
  return options.windowSize.value_or(std::pair(usualWidth, usualHeight));
}

/// Whether the camera should be placed anew: the mesh has another unit or up axis.
bool differsInSize(const scene::Scene& a, const scene::Scene& b) {
  constexpr double much = 1.5;
  const double tolerance = 0.02 * std::max(*std::max_element(a.summary.size.begin(), a.summary.size.end()),
                                           *std::max_element(b.summary.size.begin(), b.summary.size.end()));
  for (std::size_t axis = 0; axis < a.summary.size.size(); ++axis) {
    // A flat cloth has a side of zero, so the comparison needs an absolute tolerance.
    const double one = a.summary.size[axis] + tolerance;
    const double other = b.summary.size[axis] + tolerance;
    if (one > much * other || other > much * one) {
      return true;
    }
  }
  return false;
}

}  // namespace

Viewer::Viewer(const std::shared_ptr<const scene::Scene>& scene, FabricList fabrics, PreferencesFile preferences,
               const ViewerOptions& options)
    : window_("Drape", openingSize(options).first, openingSize(options).second),
      panels_(measureDisplay(scene->settings.view.fontScale), ui::UserInterface::Backend::OpenGl),
      events_(window_.window()),
      fabrics_(std::move(fabrics)),
      preferencesFile_(std::move(preferences)),
      preferences_(preferencesFile_.values()),
      keepsWindowPlace_(!options.windowSize),
      status_(options.statusFile),
      simulation_(scene, options.paused || scene->description.parts.dressed),
      dressingChoices_(options.dressing),
      sceneToDress_(scene->description.parts.dressed ? scene : nullptr),
      wasPaused_(options.paused),
      newScene_(scene) {
  resizeWindow(window_.window(), options, preferences_.window);
  glfwSwapInterval(1);
  simulation_.callOnMotion(glfwPostEmptyEvent);
  if (!options.recordFile.empty()) {
    record_.emplace(options.recordFile, "the session log");
  }
  restorePreferences(options);
  if (!fabrics_.problem().empty()) {
    showError(text::Sentence::verbatim(fabrics_.problem()));
  }
}

void Viewer::run() {
  while (glfwWindowShouldClose(window_.window()) == GLFW_FALSE) {
    const auto start = Clock::now();
    awaitEvents();
    updateStats(start);
    frame();
    followExport();
    keepPreferences();
    pace(start);
  }
  export_.reset();  // it may wait for the simulation, which ends now
  if (record_) {
    write(sessionLogOf(simulation_.finish()), *record_);
  }
}

bool Viewer::isMinimised() const {
  return glfwGetWindowAttrib(window_.window(), GLFW_ICONIFIED) == GLFW_TRUE;
}

/// Waits when nothing moves, to save power. Any event wakes the window at once.
void Viewer::awaitEvents() {
  constexpr auto restless = std::chrono::milliseconds(800);
  // Sleeping cloth gets older; a paused clock shows nothing new.
  const double calmFrame = isPaused_ ? 0.25 : 2.0;  // [s]
  if ((isMinimised() && !export_) || Clock::now() - lastChange_ > restless) {
    glfwWaitEventsTimeout(calmFrame);
  }
  status_.noteInput();
  glfwPollEvents();
}

void Viewer::frame() {
  const session::Snapshot& snapshot = simulation_.latest();
  display_ = measureDisplay(snapshot.settings.view.fontScale);
  limitWindowSize();
  if (display_.width <= 0 || display_.height <= 0) {
    return;  // minimised
  }
  ui::UiOutput output;
  panels_.setDisplay(display_);
  controller_.setView(panels_.view(), display_.scale);
  followScene(snapshot);
  endNotice(snapshot);
  controller_.placing().follow(snapshot);
  takeLoadedScene(snapshot);
  followDressing(snapshot);
  followQuestion();
  followComparison(snapshot);
  events_.beginFrame();
  stats_.field = &fieldDisplay_.update(snapshot, fields_);
  stats_.fields = &fields_;
  panels_.build(snapshot, stats_, output);
  controller_.setView(panels_.view(), display_.scale);
  const session::Snapshot& shown = controller_.placing().shown(snapshot);  // with the gizmo that the panels have drawn
  handleInput(snapshot, output);
  followCamera(snapshot);
  watchChanges(snapshot, output);
  draw(shown);
  status_.update(
      {snapshot, controller_.camera(), panels_, display_, stats_, ++frameCount_, pictureCount_, firstFrameSeconds_});
  execute(output, snapshot);
  takeChosenFiles(snapshot);
  followPicks();
}

void Viewer::limitWindowSize() {
  if (std::exchange(limitedScale_, display_.scale) == display_.scale) {
    return;
  }
  const float scale = std::clamp(display_.scale, 1.0F, maxLimitScale);
  glfwSetWindowSizeLimits(window_.window(), static_cast<int>(smallestWidth * scale),
                          static_cast<int>(smallestHeight * scale), GLFW_DONT_CARE, GLFW_DONT_CARE);
}

/// Draws the parts of the window that have changed.
void Viewer::draw(const session::Snapshot& snapshot) {
  const ui::UiRect view = panels_.view();
  if (controller_.placing().isOn() || export_) {
    pictureWatch_.forget();  // the gizmo and films change the picture without a new state
  }
  const std::span<const int> picked = panels_.picked().vertices();
  const PictureWatch::Parts parts = pictureWatch_.changed({.scene = snapshot.scene,
                                                           .version = snapshot.pictureVersion,
                                                           .camera = controller_.camera().pose(),
                                                           .width = view.width * display_.density,
                                                           .height = view.height * display_.density,
                                                           .picked = {picked.begin(), picked.end()}},
                                                          panels_.fingerprint());
  if (!parts.window || isMinimised()) {
    return;
  }
  const auto pixels = [&](double length) {
    return std::max(1, static_cast<int>(std::lround(length * display_.density)));
  };
  if (parts.scene) {
    const bool places = controller_.placing().isOn();  // then the picture shows the start, which has no field
    renderer_.draw(snapshot, controller_.camera(), pixels(view.width), pixels(view.height),
                   {.field = places ? nullptr : stats_.field, .picked = picked});
  }
  blit(view);
  panels_.renderDrawData();
  glfwSwapBuffers(window_.window());
  if (pictureCount_++ == 0) {
    firstFrameSeconds_ = processAge();
  }
}

/// Copies the picture into the free area beside the panels.
void Viewer::blit(const ui::UiRect& view) {
  int windowWidth = 0;
  int windowHeight = 0;
  glfwGetFramebufferSize(window_.window(), &windowWidth, &windowHeight);
  const auto pixels = [&](double length) { return static_cast<int>(std::lround(length * display_.density)); };
  renderer_.blitToWindow(pixels(view.x), windowHeight - pixels(view.y) - pixels(view.height));
  glViewport(0, 0, windowWidth, windowHeight);
}

void Viewer::pace(Clock::time_point start) {
  // Some systems swap at once and ignore the swap interval. Waiting here leaves the processor to the simulation.
  const auto period = std::chrono::duration<double>(1.0 / measureMonitor().refreshRate);
  const auto spent = Clock::now() - start;
  if (spent < 0.75 * period) {
    std::this_thread::sleep_for(period - spent);
  }
}

void Viewer::updateStats(Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - lastFrame_).count();
  lastFrame_ = now;
  stats_.frameSeconds += frameSmoothing * (seconds - stats_.frameSeconds);
  stats_.loading = loader_.activity();
}

/// The notice hides a message of the simulation that was there before, until its time is over or another message comes.
void Viewer::endNotice(const session::Snapshot& snapshot) {
  std::string message = snapshot.message.english();
  std::erase_if(message, [](unsigned char c) { return std::isdigit(c) != 0; });  // figures change in every frame
  if (Clock::now() > noticeEnds_ || (!message.empty() && message != lastMessage_)) {
    stats_.notice = {};
  }
  lastMessage_ = std::move(message);
}

ui::UiDisplay Viewer::measureDisplay(double fontScaleSetting) const {
  ui::UiDisplay display;
  int framebufferWidth = 0;
  int framebufferHeight = 0;
  float contentScale = 1.0F;
  glfwGetWindowSize(window_.window(), &display.width, &display.height);
  glfwGetFramebufferSize(window_.window(), &framebufferWidth, &framebufferHeight);
  glfwGetWindowContentScale(window_.window(), &contentScale, nullptr);
  display.density = static_cast<float>(std::max(1, framebufferWidth)) / static_cast<float>(std::max(1, display.width));
  // Where window units are larger than pixels, they already include the monitor's scale.
  display.scale = ui::uiScale(fontScaleSetting, contentScale / display.density, measureMonitor().rows);
  return display;
}

void Viewer::takeLoadedScene(const session::Snapshot& snapshot) {
  const auto outcome = loader_.poll();
  if (!outcome) {
    return;
  }
  if (!outcome->scene) {
    controller_.placing().expectNothing();
    showError(outcome->error);
    return;
  }
  if (outcome->kind == ui::SceneLoader::Kind::Opened && asksAboutBody(*outcome->scene)) {
    return;
  }
  simulation_.post(session::LoadSceneCommand{outcome->scene});
  if (outcome->kind == ui::SceneLoader::Kind::Opened) {
    dressingChoices_.reset();
  }
  // A placement leaves the garment where the user puts it, until the user dresses the body from there.
  const scene::SceneParts& parts = outcome->scene->description.parts;
  const bool isOpened = outcome->kind == ui::SceneLoader::Kind::Opened;
  if (parts.dressed && outcome->kind != ui::SceneLoader::Kind::Placed && (isOpened || !parts.placed)) {
    wasPaused_ = dressing_ || sceneToDress_ ? wasPaused_ : snapshot.paused;
    sceneToDress_ = outcome->scene;
    simulation_.post(session::PauseCommand{true});
  }
  if (outcome->kind != ui::SceneLoader::Kind::Opened) {
    keepOwnFabrics(snapshot);
  }
  using Kind = ui::SceneLoader::Kind;
  if (outcome->kind == Kind::Rebuilt || outcome->kind == Kind::Restored) {
    resizedScene_ = differsInSize(*outcome->scene, *snapshot.scene) ? outcome->scene : nullptr;
  }
  if (outcome->kind == Kind::Rebuilt || outcome->kind == Kind::Placed) {
    // Keep the user's changes since the start of the build.
    for (auto& change : session::runningChanges(outcome->scene->settings, snapshot.settings)) {
      simulation_.post(std::move(change));
    }
    keepSewing(*outcome->scene, snapshot);
    if (outcome->kind == Kind::Placed) {
      keepPinsAndBodies(*outcome->scene, snapshot);
      keepDressing(*outcome->scene, snapshot);
    }
  } else if (outcome->kind == Kind::Opened) {
    newScene_ = outcome->scene;
    text::Sentence notice("Opened '{}'", ui::inWords(outcome->scene->description));
    notice.append(". ", std::exchange(notOpened_, {}));
    if (outcome->scene->summary.hasSkin && outcome->scene->description.bodies.empty()) {
      notice.append(". ", text::Sentence("It is a figure with bones: drop a garment to dress it"));
    }
    showNotice(notice);
  }
}

void Viewer::showTitle() {
  const std::string scene = panels_.language().texts(ui::inWords(shownScene_->description));
  glfwSetWindowTitle(window_.window(), (scene + " \u2013 Drape").c_str());
}

void Viewer::followScene(const session::Snapshot& snapshot) {
  if (snapshot.scene == shownScene_) {
    return;
  }
  shownScene_ = snapshot.scene;
  showTitle();
  if (shownScene_ == newScene_) {
    openedScene_ = shownScene_;
    controller_.lookAtScene(*shownScene_);
    undo_.forget();
    controller_.placing().forget();
    savedFile_.clear();
    savedState_.reset();
    noteOpenedFiles(shownScene_->description.parts);
    newScene_.reset();
  } else if (shownScene_ == resizedScene_) {
    controller_.frameCloth(snapshot);
    resizedScene_.reset();
  }
  if (!shownScene_->summary.warnings.empty()) {
    showNotice(text::Sentence::verbatim(shownScene_->summary.warnings.front()));
  } else if (!shownScene_->description.notes.empty()) {
    showNotice(text::Sentence::verbatim(shownScene_->description.notes.front()));
  }
}

bool Viewer::belongsToPanels(const ui::InputEvent& event) {
  if (const auto* move = std::get_if<ui::MoveEvent>(&event)) {
    mouse_ = move->position;
    return false;  // a drag that began in the picture continues over the panels
  }
  if (const auto* press = std::get_if<ui::PressEvent>(&event)) {
    return panels_.covers(press->position);
  }
  if (std::holds_alternative<ui::ScrollEvent>(event)) {
    return panels_.covers(mouse_);
  }
  if (const auto* key = std::get_if<ui::KeyEvent>(&event)) {
    // A held key must not close what its first press opened.
    const bool closes = key->key == ui::Key::Escape && !key->repeated && !controller_.holdsCloth();
    const bool quits = key->key == ui::Key::Q && key->control;  // also while a text is typed
    return (panels_.takesText() && !quits) || (closes && !controller_.placing().isDragging() && panels_.closeOverlay());
  }
  return false;
}

void Viewer::handleInput(const session::Snapshot& snapshot, ui::UiOutput& output) {
  const WindowEvents::Batch batch = events_.take();
  if (batch.uncovers) {
    pictureWatch_.forget();
  }
  isPaused_ = snapshot.paused;
  const bool moves = std::exchange(seenPicture_, snapshot.pictureVersion) != snapshot.pictureVersion;
  if (moves || !batch.input.empty() || events_.waiting() || !stats_.loading.empty()) {
    lastChange_ = Clock::now();
  }
  for (const ui::InputEvent& event : batch.input) {
    if (!belongsToPanels(event)) {
      controller_.handle(event, snapshot, output);
    }
  }
  if (!batch.droppedFiles.empty()) {
    output.requests.emplace_back(ui::DroppedRequest{batch.droppedFiles});
  }
  if (batch.closes) {
    output.requests.emplace_back(ui::UiAction::Quit);
  }
}

void Viewer::execute(ui::UiOutput& output, const session::Snapshot& snapshot) {
  for (session::Command& command : output.commands) {
    simulation_.post(std::move(command));
  }
  for (const ui::UiRequest& request : output.requests) {
    std::visit([&](const auto& each) { on(each, snapshot); }, request);
  }
  if (!output.hint.empty()) {
    showNotice(output.hint);
  }
}

void Viewer::showNotice(const ui::Wording& notice) {
  stats_.notice = notice;
  noticeEnds_ = Clock::now() + noticeTime;
}

void Viewer::showError(const ui::Wording& error) {
  stats_.error = error;
  ++stats_.failures;
}

void Viewer::showFailure(const std::exception& error) {
  showError(messages::sentenceOf(error));
}

}  // namespace drape::app
