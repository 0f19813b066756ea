#pragma once

#include "app/dressing/dressing_choices.hpp"
#include "app/dressing/dressing_job.hpp"
#include "app/dressing/piercing_watch.hpp"
#include "app/fabric_list.hpp"
#include "app/output_file.hpp"
#include "app/viewer/error_comparison.hpp"
#include "app/viewer/export_job.hpp"
#include "app/viewer/file_dialog.hpp"
#include "app/viewer/film_painter.hpp"
#include "app/viewer/picture_watch.hpp"
#include "app/viewer/preferences.hpp"
#include "app/viewer/status_file.hpp"
#include "app/viewer/window_events.hpp"
#include "fields/shown_field.hpp"
#include "locale/language.hpp"
#include "render/renderer.hpp"
#include "render/window_context.hpp"
#include "session/simulation_thread.hpp"
#include "ui/interaction_controller.hpp"
#include "ui/mesh_finder.hpp"
#include "ui/scene_loader.hpp"
#include "ui/undo.hpp"
#include "ui/user_interface.hpp"

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace drape::app {

/// The command-line options of the viewer.
struct ViewerOptions {
  bool paused = false;
  std::optional<std::pair<int, int>> windowSize;  ///< [window units]
  std::filesystem::path statusFile;               ///< empty: none
  std::optional<DressingChoices> dressing;        ///< how the first scene is dressed; empty: as usual
  std::optional<locale::Language> language;       ///< that the user asks for
  locale::Language usualLanguage;                 ///< that of the system, where the user has chosen none
  std::string recordFile;                         ///< of the session log (app/session_log.hpp); empty: none
};

/// The window: runs a scene on the simulation thread, draws it, and turns user input into commands.
class Viewer {
 public:
  /// @param fabrics of the user, with which the scene was opened
  Viewer(const std::shared_ptr<const scene::Scene>& scene, FabricList fabrics, PreferencesFile preferences,
         const ViewerOptions& options);

  /// Returns when the user quits. Then the session log is written; throws InputError when that fails.
  void run();

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool isMinimised() const;
  void awaitEvents();
  void frame();
  void limitWindowSize();
  void draw(const session::Snapshot& snapshot);
  void blit(const ui::UiRect& view);
  void pace(Clock::time_point start);
  void takeLoadedScene(const session::Snapshot& snapshot);
  void followScene(const session::Snapshot& snapshot);
  /// The scene and the program in the title of the window.
  void showTitle();
  void handleInput(const session::Snapshot& snapshot, ui::UiOutput& output);
  [[nodiscard]] bool belongsToPanels(const ui::InputEvent& event);
  void execute(ui::UiOutput& output, const session::Snapshot& snapshot);
  void on(const ui::OpenSceneRequest& request, const session::Snapshot& snapshot);
  void on(const ui::OpenPartsRequest& request, const session::Snapshot& snapshot);
  void on(const ui::DroppedRequest& request, const session::Snapshot& snapshot);
  void on(const ui::RebuildSceneRequest& request, const session::Snapshot& snapshot);
  void on(const ui::SaveFabricRequest& request, const session::Snapshot& snapshot);
  void on(const ui::SaveClothRequest& request, const session::Snapshot& snapshot);
  void on(const ui::SaveSceneRequest& request, const session::Snapshot& snapshot);
  void on(const ui::ThemeRequest& request, const session::Snapshot& snapshot);
  void on(const ui::LanguageRequest& request, const session::Snapshot& snapshot);
  void on(const ui::PickVertexRequest& request, const session::Snapshot& snapshot);
  void on(const ui::PlacingRequest& request, const session::Snapshot& snapshot);
  void on(const ui::SewingRequest& request, const session::Snapshot& snapshot);
  void startSewing(ui::UiAction action, const session::Snapshot& snapshot);
  void keepSewing(const scene::Scene& built, const session::Snapshot& snapshot);
  void startPlacing(ui::UiAction action, const session::Snapshot& snapshot);
  void keepPinsAndBodies(const scene::Scene& built, const session::Snapshot& snapshot);
  void keepDressing(const scene::Scene& built, const session::Snapshot& snapshot);
  void on(const ui::ExportRequest& request, const session::Snapshot& snapshot);
  [[nodiscard]] std::future<session::RecordedState> presentState();
  void followExport();
  void compareErrors(const session::Snapshot& snapshot);
  void followComparison(const session::Snapshot& snapshot);
  void dress(const session::Snapshot& snapshot);
  void placeOnBody(const session::Snapshot& snapshot);
  void placeGarment(const std::optional<sim::contact::Pose>& pose, const session::Snapshot& snapshot);
  void askAbout(const ui::DroppedFiles& files);
  [[nodiscard]] bool asksAboutBody(const scene::Scene& opened);
  void followQuestion();
  void beginDressing(const session::Snapshot& snapshot, DressingOrder order, bool isPaused);
  void followDressing(const session::Snapshot& snapshot);
  void endDressing(const DressingJob::Outcome& outcome, bool onlyPlaced, const session::Snapshot& snapshot);
  void cancelDressing();
  [[nodiscard]] DressingOrder orderToOpen(const session::Snapshot& snapshot) const;
  void saveProbes(const session::Snapshot& snapshot);
  void followPicks();
  void followCamera(const session::Snapshot& snapshot);
  [[nodiscard]] std::string sceneKey(const session::Snapshot& snapshot) const;
  void keepView(std::size_t place, const session::Snapshot& snapshot);
  void recallView(std::size_t place, const session::Snapshot& snapshot);
  void on(ui::UiAction action, const session::Snapshot& snapshot);
  void selectOrPin(ui::UiAction action, const session::Snapshot& snapshot);
  void undoOrRedo(ui::UiAction action, const session::Snapshot& snapshot);
  void watchChanges(const session::Snapshot& snapshot, ui::UiOutput& output);
  [[nodiscard]] bool hasUnsavedChanges(const session::Snapshot& snapshot) const;
  void openFileDialog();
  void takeChosenFiles(const session::Snapshot& snapshot);
  void noteOpenedFiles(const scene::SceneParts& parts);
  void noteFile(const std::filesystem::path& file);
  void restorePreferences(const ViewerOptions& options);
  void keepPreferences();
  void keepOwnFabrics(const session::Snapshot& snapshot);
  void resetAll(const session::Snapshot& snapshot);
  void stopWork();
  void quitOrAsk(const session::Snapshot& snapshot);
  void saveScreenshot(const session::Snapshot& snapshot);
  void showNotice(const ui::Wording& notice);
  void showError(const ui::Wording& error);
  void showFailure(const std::exception& error);
  [[nodiscard]] ui::UiDisplay measureDisplay(double fontScaleSetting) const;
  void updateStats(Clock::time_point now);
  void endNotice(const session::Snapshot& snapshot);

  render::WindowContext window_;
  render::Renderer renderer_;
  ui::UserInterface panels_;
  WindowEvents events_;
  ui::InteractionController controller_;
  ui::SceneLoader loader_;
  ui::MeshFinder finder_;  ///< of the files that the user is asked about
  FabricList fabrics_;
  PreferencesFile preferencesFile_;
  Preferences preferences_;
  bool keepsWindowPlace_ = true;
  std::optional<WindowPlace> firstPlace_;  ///< of the window, until the user changes it
  FileDialog dialog_;
  ui::Undo undo_;
  StatusFile status_;
  PictureWatch pictureWatch_;
  bool isPaused_ = false;          ///< in the last frame
  std::int64_t seenPicture_ = -1;  ///< Snapshot::pictureVersion of the last frame
  std::optional<OutputFile> record_;
  session::SimulationThread simulation_;
  std::optional<FilmPainter> filmPainter_;             ///< of the film that is written
  std::unique_ptr<ExportJob> export_;                  ///< null: none is under way
  std::unique_ptr<ErrorComparison> comparison_;        ///< of the sources of error; null: none is under way
  std::shared_ptr<const scene::Scene> comparedScene_;  ///< of the last comparison
  settings::Settings comparedSettings_;
  PiercingWatch piercings_;
  std::optional<DressingChoices> dressingChoices_;    ///< of the command line, until another scene is opened
  std::shared_ptr<const scene::Scene> sceneToDress_;  ///< opened to be dressed, and not shown yet; the clock waits
  std::shared_ptr<const scene::Scene> dressedScene_;  ///< of the dressing that is under way
  bool wasPaused_ = false;                            ///< before the dressing
  bool dressesWhenBuilt_ = false;                     ///< whether the user wants to dress a placement that is built
  std::unique_ptr<DressingJob> dressing_;             ///< null: none is under way

  std::shared_ptr<const scene::Scene> shownScene_;   ///< the title bar has its name
  std::shared_ptr<const scene::Scene> openedScene_;  ///< the last opened scene, before any change of its settings
  std::shared_ptr<const scene::Scene> newScene_;     ///< not shown yet; the camera will take the view of the scene file
  std::shared_ptr<const scene::Scene> resizedScene_;  ///< not shown yet; the camera will keep its direction
  std::filesystem::path savedFile_;                   ///< of this scene, if the user saved it; empty: none
  std::optional<session::UserState> savedState_;      ///< in that file
  std::optional<ui::DroppedFiles> perhapsBody_;       ///< asked about if the mesh that is being opened is closed
  text::Sentence notOpened_;                          ///< dropped files that were not opened, and why
  ui::UiStats stats_;
  fields::SnapshotFields fields_;
  fields::FieldDisplay fieldDisplay_;
  bool observes_ = false;  ///< whether the simulation was asked for what picked vertices need
  ui::UiDisplay display_;
  float limitedScale_ = 0.0F;  ///< for which the smallest size of the window was set
  Vec2 mouse_ = Vec2::Zero();
  Clock::time_point lastFrame_ = Clock::now();
  Clock::time_point noticeEnds_ = Clock::now();
  std::string lastMessage_;                      // of the simulation in the last frame, without digits
  Clock::time_point nextKeep_ = Clock::now();    ///< when the preferences are compared with their file again
  Clock::time_point lastChange_ = Clock::now();  ///< time of the last motion or user input
  double lastTurn_ = 0.0;                        ///< when the turntable turned last, by GLFW's clock [s]
  std::int64_t frameCount_ = 0;
  std::int64_t pictureCount_ = 0;   ///< of frames that were drawn
  double firstFrameSeconds_ = 0.0;  ///< from the start of the program to the first frame on screen [s]
};

}  // namespace drape::app
