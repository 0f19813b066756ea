// Exports of the window: frames, motions and films.
#include "app/exported_cloth.hpp"
#include "app/viewer/export_name.hpp"
#include "app/viewer/viewer.hpp"
#include "messages/error.hpp"

#include <filesystem>
#include <future>
#include <memory>

namespace drape::app {

void Viewer::on(const ui::ExportRequest& request, const session::Snapshot& snapshot) {
  try {
    if (export_) {
      throw messages::InputError("an export is running; cancel it first");
    }
    stats_.error = {};
    const std::string file = exportName(request, std::filesystem::current_path(), snapshot.scene->description.name);
    if (request.format->kind == ui::ExportKind::Frame) {
      exportFrame(*snapshot.scene, *snapshot.model, snapshot.positions, file);
      showNotice(text::Sentence("Saved {}", file));
      return;
    }
    ExportOrder order{request, file, snapshot.scene, snapshot.placedStart, undo_.present(), {}};
    if (request.start == ui::ExportRequest::Start::Present) {
      order.beginning = presentState();
    }
    if (request.format->kind == ui::ExportKind::Film) {
      filmPainter_.emplace(controller_.camera(), request.width, request.height, request.turns);
    }
    export_ = std::make_unique<ExportJob>(std::move(order));
    stats_.exporting = export_->progress();
  } catch (const std::exception& error) {
    filmPainter_.reset();
    showFailure(error);
  }
}

/// The state of the simulation after the step in progress.
std::future<session::RecordedState> Viewer::presentState() {
  const auto promise = std::make_shared<std::promise<session::RecordedState>>();
  simulation_.inspect([promise](const session::Simulation& simulation) { promise->set_value(simulation.recorded()); });
  return promise->get_future();
}

/// Draws for the export, and shows how far it is.
void Viewer::followExport() {
  if (!export_) {
    return;
  }
  lastChange_ = Clock::now();
  if (filmPainter_) {
    export_->serve(
        [&](const session::Snapshot& snapshot, double share) { return filmPainter_->draw(snapshot, share, panels_); });
  }
  stats_.exporting = export_->progress();
  if (const auto outcome = export_->poll()) {
    export_.reset();
    filmPainter_.reset();
    stats_.exporting.reset();
    outcome->hasFailed ? showError(outcome->message) : showNotice(outcome->message);
  }
}

}  // namespace drape::app
