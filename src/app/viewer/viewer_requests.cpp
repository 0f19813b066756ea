// What the user asks of the window, apart from files, exports and dressing.
#include "app/exported_cloth.hpp"
#include "app/viewer/free_name.hpp"
#include "app/viewer/viewer.hpp"
#include "messages/error.hpp"
#include "settings/settings_table.hpp"
#include "ui/scene_loader.hpp"
#include "ui/shortcuts.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace drape::app {

void Viewer::on(const ui::OpenSceneRequest& request, const session::Snapshot& snapshot) {
  notOpened_ = {};  // the message about files that were dropped earlier
  on(ui::OpenPartsRequest{{.scene = request.nameOrPath}}, snapshot);
}

void Viewer::on(const ui::DroppedRequest& request, const session::Snapshot& snapshot) {
  const ui::DroppedFiles files = ui::joinedWith(*snapshot.scene, ui::sortDropped(request.files));
  const ui::DropDecision decision = ui::decide(files);
  if (decision.open) {
    on(ui::OpenPartsRequest{*decision.open}, snapshot);
    perhapsBody_ = ui::joinedIfBody(*snapshot.scene, files);
  }
  panels_.forgetQuestions();
  if (decision.ask) {
    askAbout(files);
  }
  notOpened_ = decision.notice;
  if (!notOpened_.empty()) {
    showNotice(notOpened_);
  }
}

void Viewer::askAbout(const ui::DroppedFiles& files) {
  panels_.askWhichIsTheCloth(files);
  finder_.find(files.meshes);
}

/// Whether the opened mesh is closed or has bones, so that it may be the body for the garment in the window. Then the
/// user is asked.
bool Viewer::asksAboutBody(const scene::Scene& opened) {
  const std::optional<ui::DroppedFiles> files = std::exchange(perhapsBody_, std::nullopt);
  const bool looksLikeBody = opened.summary.hasSkin || opened.summary.boundaryLoops == 0;
  if (!files || opened.description.parts.scene != files->alone || !looksLikeBody) {
    return false;
  }
  askAbout(*files);
  return true;
}

/// Reads what the user is asked about, as long as the question is open.
void Viewer::followQuestion() {
  if (!panels_.asksWhichIsTheCloth()) {
    if (!finder_.found().empty()) {
      finder_.forget();
    }
    stats_.found = {};
    return;
  }
  finder_.follow();
  stats_.found = finder_.found();
  if (finder_.isReading()) {
    lastChange_ = Clock::now();
  }
}

void Viewer::on(const ui::OpenPartsRequest& request, const session::Snapshot& snapshot) {
  stats_.error = {};
  perhapsBody_.reset();
  loader_.open(
      request.parts,
      [current = snapshot.settings, own = snapshot.scene->description.settings](settings::Settings& target) {
        ui::useWindowDefaults(target);
        ui::carryViewSettings(current, own, target);
      },
      fabrics_.fabrics());
}

void Viewer::on(const ui::RebuildSceneRequest& request, const session::Snapshot& snapshot) {
  stats_.error = {};
  using Kind = ui::SceneLoader::Kind;
  const scene::Placements placements = request.placements.value_or(controller_.placing().placements(snapshot));
  if (request.placements) {
    controller_.placing().expect(placements);
  }
  loader_.rebuild(scene::withPlacements(snapshot.scene->description, placements), request.settings,
                  request.placements ? Kind::Placed : Kind::Rebuilt);
}

void Viewer::on(const ui::SaveFabricRequest& request, const session::Snapshot& snapshot) {
  const settings::OwnFabric& fabric = request.fabric;
  try {
    std::filesystem::path file = fabrics_.file();
    if (request.place == ui::SaveFabricRequest::Place::Scene) {
      file = snapshot.scene->description.parts.scene;
      saveFabric(file, fabric);
    } else {
      fabrics_.add(fabric);
    }
    simulation_.post(session::SetOwnFabricsCommand{settings::withOwnFabric(snapshot.settings.fabric.own, fabric)});
    simulation_.post(session::UseFabricCommand{fabric});
    showNotice(text::Sentence("Saved the fabric '{}' in {}", fabric.name, file.string()));
  } catch (const messages::InputError& error) {
    showFailure(error);
  }
}

void Viewer::on(ui::UiAction action, const session::Snapshot& snapshot) {
  switch (action) {
    case ui::UiAction::TogglePanels:
      panels_.showPanels(!panels_.panelsVisible());
      break;
    case ui::UiAction::ToggleHelp:
      panels_.showHelp(!panels_.helpVisible());
      break;
    case ui::UiAction::Screenshot:
      saveScreenshot(snapshot);
      break;
    case ui::UiAction::SaveCloth:
      on(ui::SaveClothRequest{}, snapshot);
      break;
    case ui::UiAction::SaveScene:
      on(ui::SaveSceneRequest{}, snapshot);
      break;
    case ui::UiAction::OpenFile:
      openFileDialog();
      break;
    case ui::UiAction::Search:
      panels_.toggleSearch(preferences_.recentFiles);
      break;
    case ui::UiAction::Undo:
    case ui::UiAction::Redo:
      undoOrRedo(action, snapshot);
      break;
    case ui::UiAction::NextTheme:
      on(ui::ThemeRequest{panels_.theme() == ui::Theme::Dark ? ui::Theme::Light : ui::Theme::Dark}, snapshot);
      break;
    case ui::UiAction::ShowExport:
      panels_.showExport();
      break;
    case ui::UiAction::CancelExport:
      if (export_) {
        export_->cancel();
      }
      break;
    case ui::UiAction::Dress:
      dress(snapshot);
      break;
    case ui::UiAction::PlaceOnBody:
      placeOnBody(snapshot);
      break;
    case ui::UiAction::CancelDressing:
      cancelDressing();
      break;
    case ui::UiAction::CompareErrors:
      compareErrors(snapshot);
      break;
    case ui::UiAction::CancelComparison:
      if (comparison_) {
        comparison_->cancel();
      }
      break;
    case ui::UiAction::SaveProbes:
      saveProbes(snapshot);
      break;
    case ui::UiAction::RecallView1:
    case ui::UiAction::RecallView2:
    case ui::UiAction::RecallView3:
    case ui::UiAction::RecallView4:
      recallView(static_cast<std::size_t>(action) - static_cast<std::size_t>(ui::UiAction::RecallView1), snapshot);
      break;
    case ui::UiAction::KeepView1:
    case ui::UiAction::KeepView2:
    case ui::UiAction::KeepView3:
    case ui::UiAction::KeepView4:
      keepView(static_cast<std::size_t>(action) - static_cast<std::size_t>(ui::UiAction::KeepView1), snapshot);
      break;
    case ui::UiAction::SelectRectangle:
    case ui::UiAction::SelectBorder:
    case ui::UiAction::PinSelected:
    case ui::UiAction::ReleaseSelected:
    case ui::UiAction::TogglePinsSelected:
    case ui::UiAction::EndSelection:
      selectOrPin(action, snapshot);
      break;
    case ui::UiAction::Sew:
    case ui::UiAction::SetBand:
      startSewing(action, snapshot);
      break;
    case ui::UiAction::Place:
      startPlacing(action, snapshot);
      break;
    case ui::UiAction::ToggleProjection:
    case ui::UiAction::ToggleTurntable:
    case ui::UiAction::FrameCloth:
    case ui::UiAction::ViewFront:
    case ui::UiAction::ViewRight:
    case ui::UiAction::ViewTop:
      controller_.moveCamera(action, snapshot);
      break;
    case ui::UiAction::ResetAll:
      resetAll(snapshot);
      break;
    case ui::UiAction::Stop:
      stopWork();
      break;
    case ui::UiAction::Quit:
      quitOrAsk(snapshot);
      break;
    case ui::UiAction::QuitAndLoseChanges:
      glfwSetWindowShouldClose(window_.window(), GLFW_TRUE);
      break;
  }
}

void Viewer::selectOrPin(ui::UiAction action, const session::Snapshot& snapshot) {
  ui::UiOutput output;
  controller_.select(action, snapshot, output);
  undo_.noteCommands(output.commands);
  execute(output, snapshot);
}

/// Loads the scene as it is when its mesh settings and placements are the author's; otherwise builds it again.
void Viewer::resetAll(const session::Snapshot& snapshot) {
  stats_.error = {};
  const scene::Scene& scene = *snapshot.scene;
  settings::Settings own = scene.description.settings;
  ui::useWindowDefaults(own);
  const scene::Placements written = scene::writtenPlacementsOf(scene.description);
  const bool isPlaced = controller_.placing().placements(snapshot) != written;
  if (!isPlaced && settings::differingSettings(scene.settings, own).empty()) {
    simulation_.post(session::LoadSceneCommand{snapshot.scene});
    keepOwnFabrics(snapshot);
    if (snapshot.placedStart) {
      simulation_.post(session::PlaceClothCommand{*snapshot.placedStart, true});
    }
  } else {
    controller_.placing().expect(written);
    loader_.rebuild(scene::withPlacements(scene.description, written), own, ui::SceneLoader::Kind::Restored);
  }
}

/// The scene as it was built does not have the fabrics that the user saved since.
void Viewer::keepOwnFabrics(const session::Snapshot& snapshot) {
  if (snapshot.settings.fabric.own != snapshot.scene->settings.fabric.own) {
    simulation_.post(session::SetOwnFabricsCommand{snapshot.settings.fabric.own});
  }
}

/// Esc must not end the program: users press it to leave a mode that has ended already.
void Viewer::stopWork() {
  if (dressing_) {
    cancelDressing();
  } else if (loader_.cancel()) {
    controller_.placing().expectNothing();
    showNotice("Stopped. The scene did not change");
  } else {
    showNotice(text::Sentence("Nothing is open. {} quits", ui::keysInWords(ui::quitKeys, panels_.language().texts)));
  }
}

void Viewer::quitOrAsk(const session::Snapshot& snapshot) {
  const bool hasChanges = hasUnsavedChanges(snapshot);
  if (hasChanges || export_) {
    panels_.askToQuit(hasChanges);
  } else {
    glfwSetWindowShouldClose(window_.window(), GLFW_TRUE);
  }
}

void Viewer::saveScreenshot(const session::Snapshot& snapshot) {
  try {
    const std::filesystem::path file =
        freeName(std::filesystem::current_path(), snapshot.scene->description.name, ".png");
    // Pins are a tool for the user, not part of a picture.
    session::Snapshot bare = snapshot;
    bare.settings.view.pins = false;
    const render::Image shown = renderer_.read();
    renderer_.draw(bare, controller_.camera(), shown.width, shown.height, {.field = stats_.field});
    if (stats_.field != nullptr && stats_.field->field != nullptr) {
      const ui::UiRect view = panels_.view();
      renderer_.bindTarget();
      panels_.drawLegend(bare, stats_, static_cast<int>(view.width), static_cast<int>(view.height));
    }
    render::writePng(renderer_.read(), file);
    pictureWatch_.forget();
    showNotice(text::Sentence("Saved {}", file.string()));
  } catch (const std::exception& error) {
    showFailure(error);
  }
}

void Viewer::on(const ui::SaveClothRequest& request, const session::Snapshot& snapshot) {
  try {
    const std::filesystem::path file =
        request.path.empty() ? freeName(std::filesystem::current_path(), snapshot.scene->description.name, ".obj")
                             : std::filesystem::absolute(request.path);
    exportFrame(*snapshot.scene, *snapshot.model, snapshot.positions, file);
    showNotice(text::Sentence("Saved {}", file.string()));
  } catch (const std::exception& error) {
    showFailure(error);
  }
}

void Viewer::on(const ui::PickVertexRequest& request, const session::Snapshot& /*snapshot*/) {
  if (!panels_.pick(request.vertex)) {
    showNotice("Four vertices are marked. Right click one of them to remove its mark.");
  }
}

void Viewer::saveProbes(const session::Snapshot& snapshot) {
  try {
    const std::filesystem::path file =
        freeName(std::filesystem::current_path(), snapshot.scene->description.name, ".csv");
    if (!replaceFile(file, panels_.picked().csv())) {
      throw messages::InputError("could not write " + file.string() + ": " + std::strerror(errno));
    }
    showNotice(text::Sentence("Saved {}", file.string()));
  } catch (const std::exception& error) {
    showFailure(error);
  }
}

/// Asks the simulation for velocities and contact loads while vertices are picked.
void Viewer::followPicks() {
  const bool picked = !panels_.picked().vertices().empty();
  if (picked != observes_) {
    observes_ = picked;
    simulation_.post(session::ObserveCommand{picked});
  }
}

}  // namespace drape::app
