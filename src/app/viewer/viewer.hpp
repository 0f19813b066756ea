#pragma once

#include "app/output_file.hpp"
#include "app/viewer/status_file.hpp"
#include "app/viewer/window_events.hpp"
#include "render/renderer.hpp"
#include "render/window_context.hpp"
#include "session/simulation_thread.hpp"
#include "ui/interaction_controller.hpp"
#include "ui/scene_loader.hpp"
#include "ui/user_interface.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace drape {

/// The command-line options of the viewer.
struct ViewerOptions {
  bool paused = false;
  std::optional<std::pair<int, int>> windowSize;  ///< [window units]
  std::filesystem::path statusFile;               ///< empty: none
  std::string recordFile;                         ///< of the session log (app/session_log.hpp); empty: none
};

/// The window: runs a scene on the simulation thread, draws it, and turns user input into commands.
class Viewer {
 public:
  Viewer(const std::shared_ptr<const Scene>& scene, const ViewerOptions& options);

  /// Returns when the user quits. Then the session log is written; throws InputError when that fails.
  void run();

 private:
  using Clock = std::chrono::steady_clock;

  void awaitEvents() const;
  void frame();
  void draw(const Snapshot& snapshot);
  void blit(const UiRect& view);
  void pace(Clock::time_point start);
  void takeLoadedScene(const Snapshot& snapshot);
  void followScene(const Snapshot& snapshot);
  void handleInput(const Snapshot& snapshot, UiOutput& output);
  [[nodiscard]] bool belongsToPanels(const InputEvent& event);
  void execute(UiOutput& output, const Snapshot& snapshot);
  void on(const OpenSceneRequest& request, const Snapshot& snapshot);
  void on(const OpenPartsRequest& request, const Snapshot& snapshot);
  void on(const DroppedRequest& request, const Snapshot& snapshot);
  void on(const RebuildSceneRequest& request, const Snapshot& snapshot);
  void on(UiAction action, const Snapshot& snapshot);
  void resetAll(const Snapshot& snapshot);
  void stopLoadingOrQuit(const Snapshot& snapshot);
  void quitOrAsk(const Snapshot& snapshot);
  void saveScreenshot(const Snapshot& snapshot);
  void showNotice(const std::string& notice);
  void showError(const std::string& error);
  [[nodiscard]] UiDisplay measureDisplay(double fontScaleSetting) const;
  void updateStats(Clock::time_point now);

  WindowContext window_;
  Renderer renderer_;
  UserInterface panels_;
  WindowEvents events_;
  InteractionController controller_;
  SceneLoader loader_;
  StatusFile status_;
  std::optional<OutputFile> record_;
  SimulationThread simulation_;

  std::shared_ptr<const Scene> shownScene_;    ///< the title bar has its name
  std::shared_ptr<const Scene> openedScene_;   ///< the last opened scene, before any change of its settings
  std::shared_ptr<const Scene> newScene_;      ///< not shown yet; the camera will take the view of the scene file
  std::shared_ptr<const Scene> resizedScene_;  ///< not shown yet; the camera will keep its direction
  std::string notOpened_;                      ///< dropped files that were not opened, and why
  UiStats stats_;
  UiDisplay display_;
  Vec2 mouse_ = Vec2::Zero();
  Clock::time_point lastFrame_ = Clock::now();
  Clock::time_point noticeEnds_ = Clock::now();
  Clock::time_point lastChange_ = Clock::now();  ///< time of the last motion or user input
  std::int64_t frameCount_ = 0;
  double firstFrameSeconds_ = 0.0;  ///< from the start of the program to the first frame on screen [s]
};

}  // namespace drape
