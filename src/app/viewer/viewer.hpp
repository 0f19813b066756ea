#pragma once

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

/// How the viewer was asked to start.
struct ViewerOptions {
  bool paused = false;
  std::optional<std::pair<int, int>> windowSize;  ///< [window units]
  std::filesystem::path statusFile;               ///< empty: none
};

/// The window: runs a scene on the simulation's thread, shows it, and turns what the user does into commands.
class Viewer {
 public:
  Viewer(const std::shared_ptr<const Scene>& scene, const ViewerOptions& options);

  /// Until the user quits.
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
  void carryOut(UiOutput& output, const Snapshot& snapshot);
  void on(const OpenSceneRequest& request, const Snapshot& snapshot);
  void on(const OpenPartsRequest& request, const Snapshot& snapshot);
  void on(const DroppedRequest& request, const Snapshot& snapshot);
  void on(const RebuildSceneRequest& request, const Snapshot& snapshot);
  void on(UiAction action, const Snapshot& snapshot);
  void resetAll(const Snapshot& snapshot);
  void stopLoadingOrQuit(const Snapshot& snapshot);
  void quitOrAsk(const Snapshot& snapshot);
  void saveScreenshot(const Snapshot& snapshot);
  void tell(const std::string& notice);
  void complain(const std::string& error);
  [[nodiscard]] UiDisplay measureDisplay(double fontScaleSetting) const;
  void updateStats(Clock::time_point now);

  WindowContext window_;
  Renderer renderer_;
  UserInterface panels_;
  WindowEvents events_;
  InteractionController controller_;
  SceneLoader loader_;
  StatusFile status_;
  SimulationThread simulation_;

  std::shared_ptr<const Scene> shownScene_;   ///< whose name the title bar has
  std::shared_ptr<const Scene> openedScene_;  ///< the last one that was opened, before any change of its settings
  std::shared_ptr<const Scene> newScene_;     ///< on its way; it is to be looked at as its author wants
  std::shared_ptr<const Scene> grownScene_;   ///< on its way; it is to be framed from the same direction
  std::string notOpened_;                     ///< which of the files that were dropped are not opened, and why
  UiStats stats_;
  UiDisplay display_;
  Vec2 mouse_ = Vec2::Zero();
  Clock::time_point lastFrame_ = Clock::now();
  Clock::time_point noticeEnds_ = Clock::now();
  Clock::time_point lastChange_ = Clock::now();  ///< when something last moved, or the user did something
  std::int64_t frameCount_ = 0;
  double firstFrameSeconds_ = 0.0;  ///< from the start of the program until the first frame was shown [s]
};

}  // namespace drape
